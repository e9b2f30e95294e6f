#!/bin/sh
# Makes the start-up caches of a distribution: one rehearsal per program, whose loaded classes and
# profiles the JDK writes beside the jars.   warm-up.sh ROOT DIST JAVA, called by ./build.
set -eu
root=$1 dist=$2 java=$3
. "$root/scripts/flags.sh"
class_path "$root/$dist"

rehearse() { # MAIN ARGUMENTS…
  main=$1
  shift
  # shellcheck disable=SC2086
  "$java" $jvm_flags -XX:AOTCacheOutput="$root/$dist/$main.aot" -Durbi.root="$root" \
    -cp "$cp" "$main" "$@" </dev/null >"$root/.build/warm-up.log" 2>&1 || true
  [ -s "$root/$dist/$main.aot" ]
}

rehearse org.urbi.server.cli.UrbiCommand --quiet --fast "$root/scripts/warm-up.u"
rehearse org.urbi.server.tools.UrbiSend --help
rehearse org.urbi.server.tools.UrbiPing --help
