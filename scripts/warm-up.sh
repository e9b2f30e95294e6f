#!/bin/sh
# Makes the start-up cache of a distribution, urbi.aot: a rehearsal whose loaded classes
# the JDK writes beside the jars (their profiles would only make the compilers busy at start-up).   warm-up.sh ROOT DIST JAVA, called by ./build.
set -eu
root=$1 dist=$2 java=$3
unset URBI_JAVA_OPTS # the cache is for those who start without
. "$root/scripts/flags.sh"
class_path "$root/$dist"
# shellcheck disable=SC2086
timeout 120 "$java" $jvm_flags -XX:+UnlockDiagnosticVMOptions -XX:-AOTRecordTraining \
  -XX:AOTCacheOutput="$root/$dist/urbi.aot" -Durbi.root="$root" \
  -cp "$cp" org.urbi.server.cli.TrainingRun "$root/scripts/warm-up.u" </dev/null >"$root/.build/warm-up.log" 2>&1
[ -s "$root/$dist/urbi.aot" ]
