#!/bin/sh
# Makes a start-up cache of a distribution: a rehearsal whose loaded classes the JDK writes beside the
# jars (their profiles would only make the compilers busy at start-up).
#   warm-up.sh ROOT DIST JAVA [LOG]       urbi.aot, for short programs; called by ./build and scripts/packages
#   warm-up.sh ROOT DIST JAVA LOG FOLDER  server.aot, for servers and programs connected to them; for ./check
set -eu
root=$1 dist=$2 java=$3
unset URBI_JAVA_OPTS # the cache is for those who start without
collector=
. "$root/scripts/flags.sh"
distribution_class_path
log=${4:-$root/.build/warm-up.log}
if [ $# -le 4 ]; then
  cache=$root/$dist/urbi.aot
  set -- org.urbi.server.cli.TrainingRun "$(dirname "$0")/warm-up.u"
else
  cache=$root/$dist/server.aot
  WARM_UP_PORT=$5/port
  export WARM_UP_PORT
  set -- org.urbi.server.launch.ServerTrainingRun "$5" "$root/scripts/warm-up.u" "$root/scripts/warm-up-server.u"
fi
# Functions are compiled when they are called for the second time (docs/tier.md), when something is known of them, so that the
# classes of the compiler are in the cache. In two steps, since a Java that is started by Java has no descriptor of the jars
# (distribution_class_path).
# shellcheck disable=SC2086
timeout 120 "$java" $jvm_flags $cache_flags -XX:-AOTRecordTraining -XX:AOTMode=record -XX:AOTConfiguration="$cache.classes" \
  -Durbi.tier=2 -Durbi.root="$root" -cp "$cp" "$@" </dev/null >"$log" 2>&1
# shellcheck disable=SC2086
timeout 120 "$java" $jvm_flags $cache_flags -XX:AOTMode=create -XX:AOTConfiguration="$cache.classes" -XX:AOTCache="$cache.new" \
  -cp "$cp" </dev/null >>"$log" 2>&1
rm -f "$cache.classes"
# Whoever starts meanwhile has the one before, whole.
[ -s "$cache.new" ] && mv -f "$cache.new" "$cache"
