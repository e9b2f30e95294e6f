# What umake compiles once for many components, and keeps: the header urbi/uobject.hh, precompiled, and the
# code of its functions in a library. Sourced by umake, whose variables it uses.
# A folder KEY.TIME.PID holds it for one compiler with its options; its name is the last thing that it gets,
# so that nobody meets one half made, and nothing in it ever changes.

# The folder in which all is kept: that of a checkout, if it may be written, or that of the user. A package
# has none: what it did not bring would stay when it is removed.
kept_folder() {
  local each all=()
  [ ! -d "$root/.build" ] || all=("$root/.build/umake")
  all+=(${HOME:+"${XDG_CACHE_HOME:-$HOME/.cache}/urbi/umake"})
  [ -z "${URBI_UMAKE_KEPT+set}" ] || all=("$URBI_UMAKE_KEPT")
  for each in "${all[@]}"; do
    case $each in "" | *[[:space:]]*) continue ;; esac
    mkdir -p "$each" 2>/dev/null && [ -w "$each" ] && { echo "$each"; return; }
  done
  return 1
}

# What the result depends on, but for the headers of the system.
kept_key() {
  {
    printf '%s\n' "$(command -v "$compiler")" "$("$compiler" --version)" "$prefix" "$cppflags" "$flags"
    printf '%s\n' "${CPATH-}" "${CPLUS_INCLUDE_PATH-}" "${GCC_EXEC_PREFIX-}" "${COMPILER_PATH-}"
    # Folders and files of the options may be relative.
    case " $cppflags $flags " in *" -I"[!/]* | *" -i"* | *" @"* | *" -B"*) pwd ;; esac
    find -L "$prefix/include/" -type f -print0 | LC_ALL=C sort -z | xargs -0 cat
  } | sha256sum | cut -c1-32
}

is_whole() { # FOLDER
  [ -f "$1/sizes" ] && [ "$(cd "$1" && wc -c uobject.hh.gch liburbi.a 2>/dev/null)" = "$(cat "$1/sizes")" ]
}

# Whether no header of the system has changed since.
is_fresh() { # FOLDER
  local newer
  # shellcheck disable=SC2016
  newer=$(xargs sh -c 'made=$1; shift; find -L "$@" -newer "$made"' sh "$1/sizes" <"$1/headers" 2>&1) &&
    [ -z "$newer" ]
}

# Sets kept to a folder that fits.
find_kept() {
  local each
  kept=
  command -v sha256sum >/dev/null && kept_in=$(kept_folder) && kept_for=$(kept_key) || return 1
  for each in "$kept_in/$kept_for".*; do
    if is_whole "$each" && is_fresh "$each"; then
      kept=$each
      touch "$kept" 2>/dev/null || true
      return
    fi
  done
  return 1
}

# Makes what has not been found, and sets kept to it.
make_kept() {
  local new code made status=1
  [ -n "${kept_for:-}" ] || return 1
  case $prefix in *[[:space:]]*) return 1 ;; esac
  # One at a time: whoever comes second has nothing left to do.
  if command -v flock >/dev/null && exec 9>"$kept_in/lock"; then
    flock -w 120 9 || true
    if find_kept; then
      exec 9>&-
      return
    fi
  fi 2>/dev/null
  if new=$(mktemp -d "$kept_in/new.XXXXXX" 2>/dev/null); then
    chmod 755 "$new"
    {
      echo "CXX = $compiler"
      echo "AR = ${host:+$host-}ar"
      echo "OPTIONS = -I$(quoted "$prefix/include") ${cppflags//\$/\$\$} ${flags//\$/\$\$} -DURBI_SEPARATE"
      echo "all: liburbi.a"
      echo "uobject.hh.gch: uobject.hh"
      printf '\t$(CXX) $(OPTIONS) -MD -MF uobject.d -x c++-header -o $@ $<\n'
      made=
      for code in "$prefix"/include/urbi/detail/code/*.cc; do
        made+=" $(basename "$code" .cc).o"
        echo "$(basename "$code" .cc).o: $code uobject.hh.gch"
        printf '\t$(CXX) -include uobject.hh $(OPTIONS) -c -o $@ $<\n'
      done
      echo "liburbi.a:$made"
      printf '\t$(AR) rcs $@ $^\n'
    } >"$new/Makefile"
    echo "#include <urbi/uobject.hh>" >"$new/uobject.hh"
    made=$kept_in/$kept_for.$(date +%s).$$
    if make -s -j "$jobs" -C "$new" -f Makefile >/dev/null 2>&1 8>&- 9>&- &&
      sed 's/^[^:]*:\( \|$\)//; s/\\$//' "$new/uobject.d" | tr -s ' ' '\n' | grep '^/' >"$new/headers" &&
      rm -f "$new"/*.o "$new"/*.d "$new/Makefile" &&
      (cd "$new" && wc -c uobject.hh.gch liburbi.a >sizes) && is_whole "$new" &&
      mv "$new" "$made" 2>/dev/null; then
      kept=$made
      status=0
      forget_kept
    else
      rm -rf "$new"
    fi
  fi
  exec 9>&-
  return $status
}

# Removes what has been used last by others, but three, and what was left half made; all that for an hour.
forget_kept() {
  find "$kept_in" -mindepth 1 -maxdepth 1 -type d -mmin +60 -name 'new.*' -exec rm -rf {} +
  find "$kept_in" -mindepth 1 -maxdepth 1 -type d -mmin +60 -printf '%T@ %p\n' | sort -rn | tail -n +4 |
    cut -d' ' -f2- | xargs -r rm -rf
} 2>/dev/null

# Whether a source includes urbi/uobject.hh with nothing before it but headers of the language: for those it
# does not matter that it comes first.
begins_with_uobject() { # SOURCE
  case $1 in *.c) return 1 ;; esac
  [ "$(awk -v source="$1" '
    # "yes", "no", or "" where the file has ended without either.
    function judged(file, depth, line, comment, guard, path, answer) {
      if (depth > 20) return "no"
      while ((getline line < file) > 0) {
        if (comment) {
          if (!sub(/^.*\*\//, "", line)) continue
          comment = 0
        }
        gsub(/\/\*[^*]*\*\//, " ", line)
        sub(/\/\/.*/, "", line)
        if (sub(/\/\*.*/, "", line)) comment = 1
        gsub(/[ \t\r]+/, " ", line); sub(/^ /, "", line); sub(/ $/, "", line)
        sub(/^# /, "#", line)
        if (line == "" || line == "#pragma once") continue
        if (line ~ /^#include ?<urbi\/u(object|main)\.hh>$/) return "yes"
        if (line ~ /^#include ?<[a-z_]+>$/) continue
        if (line ~ /^#include ?<(assert|ctype|errno|float|limits|locale|math|setjmp|signal|stdarg|stddef|stdint|stdio|stdlib|string|time|unistd|pthread)\.h>$/) continue
        if (line ~ /^#include ?"[^"]*"$/) {
          path = line; sub(/^[^"]*"/, "", path); sub(/"$/, "", path)
          if (path == "urbi/uobject.hh") return "yes"
          if (path !~ /^\//) path = folder(file) path
          if ((getline answer < path) < 0) return "no"
          close(path)
          answer = judged(path, depth + 1)
          if (answer != "") return answer
          continue
        }
        if (guard == "" && line ~ /^#ifndef [A-Za-z_0-9]+$/) {
          guard = line; sub(/^#ifndef /, "#define ", guard)
          continue
        }
        if (guard != "" && line == guard) continue
        if (guard != "" && line == "#endif") continue
        return "no"
      }
      return ""
    }
    function folder(file) { return match(file, /.*\//) ? substr(file, 1, RLENGTH) : "" }
    BEGIN { print judged(source, 0) }
  ' 2>/dev/null)" = yes ]
}
