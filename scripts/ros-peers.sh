#!/usr/bin/env bash
# Makes the environments of Python with real ROS 2 (Kilted and Jazzy), with Cyclone DDS and with roslibpy, and that of
# Node.js with roslib, that the tests of urbi-ros speak to. It takes half a minute of processor time, once. Says what it
# could not get, and fails then.
. "$(dirname "$0")/peers.sh" ros-peers
for name in kilted jazzy cyclone bridge; do
  peer "$name" "$root/scripts/ros-peers/$name.txt" python_peer
done
peer roslib "$root/scripts/ros-peers/roslib/package-lock.json" node_peer
exit "$bad"
