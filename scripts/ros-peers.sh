#!/usr/bin/env bash
# Makes the environments of Python with real ROS 2 (Kilted and Jazzy), with Cyclone DDS and with roslibpy, and that of
# Node.js with roslib, that the tests of urbi-ros speak to. They are kept for the user, since they take half a minute of processor time, and linked to from
# .build/ros-peers. What is there already stays. Says what it could not get, and fails then.
set -uo pipefail
root=$(cd "$(dirname "$0")/.." && pwd -P)
kept=${XDG_CACHE_HOME:-$HOME/.cache}/urbi/ros-peers
links=$root/.build/ros-peers
mkdir -p "$kept" "$links" || exit 1
exec 9>"$kept/lock"
flock 9 # another check may be making them
bad=0
for name in kilted jazzy cyclone bridge; do
  wanted=$root/scripts/ros-peers/$name.txt
  # What other versions of the project want is something else.
  made=$kept/$name-$(cksum <"$wanted" | cut -d' ' -f1)
  if [ ! -e "$made/complete" ]; then
    rm -rf "$made"
    if python3 -m venv "$made" >"$made.log" 2>&1 &&
      "$made/bin/pip" install -q --disable-pip-version-check -r "$wanted" >>"$made.log" 2>&1; then
      : >"$made/complete"
    else
      echo "ros-peers: could not make $name: see $made.log" >&2
      bad=1
      continue
    fi
  fi
  [ -L "$links/$name" ] || rm -rf "${links:?}/$name"
  ln -sfn "$made" "$links/$name"
done
wanted=$root/scripts/ros-peers/roslib
made=$kept/roslib-$(cksum <"$wanted/package-lock.json" | cut -d' ' -f1)
if [ ! -e "$made/complete" ]; then
  rm -rf "$made"
  mkdir -p "$made" && cp "$wanted"/package*.json "$made"
  if command -v npm >"$made.log" && (cd "$made" && npm ci --silent --no-audit --no-fund) >>"$made.log" 2>&1; then
    : >"$made/complete"
  else
    echo "ros-peers: could not make roslib: wanted are Node.js and npm, see $made.log" >&2
    exit 1
  fi
fi
[ -L "$links/roslib" ] || rm -rf "${links:?}/roslib"
ln -sfn "$made" "$links/roslib"
exit "$bad"
