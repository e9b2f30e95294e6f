#!/usr/bin/env bash
# systemd.sh FOLDER: tries share/systemd/urbi.service with the urbi of a folder, under a systemd of its own: that it starts,
# comes back when it was killed, did not turn any more or had no memory left, does not when its command line is wrong,
# and ends when it is told to. As root; where no systemd can be started it says so, and that is all.
set -Eeuo pipefail
top=$(cd "$(dirname "$0")/../.." && pwd -P)
folder=$(cd "$1" && pwd -P)
say() { echo "check: $*" >&2; }
command -v systemd-nspawn >/dev/null || { say "no systemd-nspawn (apt-get install systemd-container): the unit is not tried"; exit; }

work=$(mktemp -d)
booted='' init=''
finish() {
  [ -z "$init" ] || kill -KILL "$init" 2>/dev/null || true
  [ -z "$booted" ] || { kill -KILL "$booted" && wait "$booted"; } 2>/dev/null || true
  rm -rf "$work"
}
trap finish EXIT
trap 'say "systemd.sh, line $LINENO: $BASH_COMMAND"' ERR
trap 'exit 130' INT TERM

chmod 755 "$work"
mkdir "$work/robot"
echo 'echo("robot is up");' >"$work/robot/robot.u"
echo 'loop| { 1 };' >"$work/robot/held.u"
echo 'var list = []| loop| { list << "x" * 100 + list.size };' >"$work/robot/memory.u"
sed 's|/usr/bin/urbi|/opt/urbi/urbi|' "$top/share/systemd/urbi.service" >"$work/urbi.service"
# All but /usr is empty, and gone at the end.
systemd-nspawn --quiet --boot --directory=/ --volatile=yes --register=no --keep-unit --console=pipe --private-network \
  --bind-ro="$folder:/opt/urbi" --bind-ro="$work/robot:/etc/urbi" \
  --bind-ro="$work/urbi.service:/etc/systemd/system/urbi.service" systemd.unit=basic.target \
  >"$work/boot" 2>&1 </dev/null &
booted=$!

inside() { nsenter --target "$init" --mount --pid --uts --ipc --net -- "$@"; }

until_is() { # SECONDS COMMAND…: waits until it succeeds
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    [ $SECONDS -lt $end ] || return 1
    sleep 0.2
  done
}

is_booted() {
  kill -0 "$booted" && init=$(pgrep -P "$booted" | head -1) && [ -n "$init" ] && inside systemctl is-active -q basic.target
}
until_is 60 is_booted 2>/dev/null || { say "no systemd can be started here: the unit is not tried"; exit; }

property() { inside systemctl show urbi --property "$1" --value; }
is() { [ "$(property "$1")" = "$2" ]; } # PROPERTY VALUE
expect() { # WHAT PROPERTY VALUE
  until_is 120 is "$2" "$3" || { say "$1: $2 is $(property "$2"), not $3"; inside journalctl --unit urbi --no-pager >&2; exit 1; }
}
says() { inside journalctl --unit urbi --no-pager | grep -q "$1"; } # TEXT
stop() { # WHAT
  local before=$SECONDS
  inside systemctl stop urbi
  expect "$1" ActiveState inactive
  expect "$1" Result success
  [ $((SECONDS - before)) -le 5 ] || { say "$1: it took $((SECONDS - before)) s"; exit 1; }
}

try() { # OPTIONS [SETTING]: with another command line
  inside sh -c "systemctl stop urbi
    mkdir -p /run/systemd/system/urbi.service.d
    printf '[Service]\nExecStart=\nExecStart=/opt/urbi/urbi --quiet --port 54000 %s\n%s\n' '$1' '${2:-}' >/run/systemd/system/urbi.service.d/try.conf
    systemctl daemon-reload; systemctl reset-failed urbi; systemctl start urbi"
}

inside systemctl start urbi
until_is 60 says 'robot is up'
expect "a start" ActiveState active
inside kill -KILL "$(property MainPID)"
expect "killed" NRestarts 1
expect "killed" ActiveState active
stop "stopped"

try '--max-hold 1h --watchdog 20s /etc/urbi/held.u'
until_is 60 says 'the kernel is held'
stop "stopped while it is held"
try '--max-hold 1h --watchdog 2s /etc/urbi/held.u'
expect "held" NRestarts 1
until_is 60 says 'status=70'
try '--max-hold 1h --watchdog 0 /etc/urbi/memory.u' Environment=URBI_JAVA_OPTS=-Xmx64m
expect "without memory" NRestarts 1
until_is 60 says 'status=71'
for wrong in /etc/urbi/none.u --prot=1; do
  try "$wrong"
  expect "with $wrong" ActiveState failed
  expect "with $wrong" NRestarts 0
done
say "the unit for systemd does what it should"
