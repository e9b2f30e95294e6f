#!/usr/bin/env bash
# Are the Java sources formatted? To look at 2,000 files takes half a minute of a processor, so only those are looked at
# whose text the same formatter has not yet found right, in whatever clone; it is kept by its digest in ~/.cache/urbi.
set -euo pipefail
cd "$(dirname "$0")/.."
. scripts/jdk.sh
find_jdk && find_maven
version=$(sed -n 's/.*<google-java-format.version>\(.*\)<\/.*/\1/p' pom.xml)
right=${XDG_CACHE_HOME:-$HOME/.cache}/urbi/formatted-$version
now=$(mktemp)
trap 'rm -f "$now"' EXIT
find . \( -name .build -o -name .git -o -name target \) -prune -o -path '*/src/*' -name '*.java' -type f -printf '%P\0' |
  xargs -0 sha256sum >"$now"
[ -f "$right" ] || { mkdir -p "${right%/*}" && : >>"$right"; }

new=$(awk 'FILENAME == ARGV[1] { right[$1]; next } !($1 in right) { print $2 }' "$right" "$now")
[ -n "$new" ] || exit 0
few=() # as regular expressions, which is what the plug-in wants
if [ "$(wc -l <<<"$new")" -le 200 ]; then
  few=("-DspotlessFiles=$(sed 's/[.$]/\\&/g; s/^/.*\//' <<<"$new" | paste -sd ,)")
fi
run_maven -q spotless:check ${few[@]+"${few[@]}"}

# In one piece, since another clone may look at the same time. What is gone for long goes when there is too much.
[ "$(wc -l <"$right")" -lt 20000 ] || : >"$right"
cut -d ' ' -f 1 "$now" | sort -u - "$right" >"$right.$$" && mv -f "$right.$$" "$right"
