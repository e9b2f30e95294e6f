#!/usr/bin/env bash
# Makes the environments of Python with real ROS 2 (Kilted and Jazzy) and with Cyclone DDS, that the tests of urbi-ros
# speak to, under .build/ros-peers. What is there already stays. Says what it could not get, and fails then.
set -uo pipefail
root=$(cd "$(dirname "$0")/.." && pwd -P)
folder=$root/.build/ros-peers
mkdir -p "$folder"
bad=0
for name in kilted jazzy cyclone; do
  wanted=$root/scripts/ros-peers/$name.txt
  cmp -s "$wanted" "$folder/$name.made" && continue
  rm -rf "${folder:?}/$name" "$folder/$name.made"
  if python3 -m venv "$folder/$name" >"$folder/$name.log" 2>&1 &&
    "$folder/$name/bin/pip" install -q --disable-pip-version-check -r "$wanted" >>"$folder/$name.log" 2>&1; then
    cp "$wanted" "$folder/$name.made"
  else
    echo "ros-peers: could not make $name: see .build/ros-peers/$name.log" >&2
    bad=1
  fi
done
exit "$bad"
