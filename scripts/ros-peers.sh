#!/usr/bin/env bash
# Makes the environments of Python with real ROS 2 (Kilted and Jazzy), with Cyclone DDS and with roslibpy, and that of
# Node.js with roslib, that the tests of urbi-ros speak to. It takes half a minute of processor time, once. Says what it
# could not get, and fails then.
. "$(dirname "$0")/peers.sh" ros-peers

# installed FOLDER: what a program that is not in Python takes for an installed ROS 2: all libraries in one folder. These
# packages link some to Python, which is not there then: what is empty takes their place.
installed() {
  [ ! -e "$1/installed/complete" ] || return 0
  rm -rf "$1/installed"
  mkdir -p "$1/installed/lib" && ln -s "$1/share" "$1/installed/share" || return
  for folder in "$1/lib" "$1"/lib/python3*/site-packages/ros_*.libs; do
    for library in "$folder"/*.so*; do
      [ ! -f "$library" ] || ln -sfn "$library" "$1/installed/lib/" || return
    done
  done
  for library in "$1"/installed/lib/*__rosidl_generator_py.so; do
    rm "$library" && echo | gcc -shared -Wl,-soname,"${library##*/}" -x c -o "$library" - || return
  done
  : >"$1/installed/complete"
}

for name in kilted jazzy cyclone bridge; do
  peer "$name" "$root/scripts/ros-peers/$name.txt" python_peer
done
for name in kilted jazzy; do
  [ ! -d "$links/$name" ] || installed "$(cd "$links/$name" && pwd -P)" ||
    { echo "ros-peers: $name has no libraries" >&2; bad=1; }
done
peer roslib "$root/scripts/ros-peers/roslib/package-lock.json" node_peer
exit "$bad"
