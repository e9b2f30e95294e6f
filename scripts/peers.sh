# Programs of others that tests speak to: sourced, with the name of their kind, by the scripts that say which. They are kept
# for the user, since making them takes long, and linked to from .build. What is there already stays.
set -uo pipefail
kind=$1
root=$(cd "$(dirname "$0")/.." && pwd -P)
kept=${XDG_CACHE_HOME:-$HOME/.cache}/urbi/$kind
links=$root/.build/$kind
mkdir -p "$kept" "$links" || exit 1
exec 9>"$kept/lock"
flock 9 # another check may be making them
bad=0

python_peer() { # FOLDER WANTED
  python3 -m venv "$1" && "$1/bin/pip" install -q --disable-pip-version-check -r "$2"
}
node_peer() { # FOLDER WANTED
  command -v npm && mkdir -p "$1" && cp "$2" "${2%-lock.json}.json" "$1" &&
    (cd "$1" && npm ci --silent --no-audit --no-fund)
}
peer() { # NAME WANTED FUNCTION: what other versions of the project want is something else
  local made
  made=$kept/$1-$(cksum <"$2" | cut -d' ' -f1)
  if [ ! -e "$made/complete" ]; then
    rm -rf "$made"
    if "$3" "$made" "$2" >"$made.log" 2>&1; then
      : >"$made/complete"
    else
      echo "$kind: could not make $1: see $made.log" >&2
      bad=1
      return
    fi
  fi
  [ -L "$links/$1" ] || rm -rf "${links:?}/$1"
  ln -sfn "$made" "$links/$1"
}
