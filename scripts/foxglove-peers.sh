#!/usr/bin/env bash
# Makes the environments of Node.js with Foxglove's client of its WebSocket protocol, and of Python with the library that
# reads MCAP files, that FoxglovePeersTest speaks to. Says what it could not get, and fails then.
. "$(dirname "$0")/peers.sh" foxglove-peers
peer mcap "$root/scripts/foxglove-peers/mcap.txt" python_peer
peer protocol "$root/scripts/foxglove-peers/protocol/package-lock.json" node_peer
exit "$bad"
