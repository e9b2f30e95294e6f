# Sourced by ./urbi and its sister tools in bin/, which set `root` and `main`: starts Java on the distribution
# of a package, or on that in .build, and builds the latter first where there is none or where another commit was
# checked out.
# Nothing is run but shell built-ins: starting a tool costs its JVM and no more.

dist= java= built_from=
if [ -x "$root/runtime/bin/java" ]; then # a package has its own Java, and there is nothing to build
  dist=dist java=$root/runtime/bin/java
elif [ -f "$root/.build/current" ]; then
  . "$root/.build/current"
fi

# The commit that the work tree stands on; in a linked work tree .git is a file that says where.
git=$root/.git
[ -f "$git" ] && read -r _ git <"$git"
commit=$built_from
if [ -f "$git/HEAD" ]; then
  read -r commit <"$git/HEAD"
  case $commit in
    "ref: "*)
      ref=${commit#ref: }
      commit=$built_from
      for refs in "$git" "$git/../.."; do
        [ -f "$refs/$ref" ] && read -r commit <"$refs/$ref" && break
      done ;;
  esac
fi

if [ ! -x "$java" ] || [ ! -d "$root/$dist/lib" ] || [ "$commit" != "$built_from" ]; then
  if [ ! -x "$root/build" ]; then
    echo "urbi: there is neither a Java runtime nor a distribution in $root: install urbi again" >&2
    exit 1
  fi
  "$root/build" --if-needed || exit 1
  . "$root/.build/current"
fi

# A server has periods to keep beside clients who fill its memory, so it collects garbage in small pieces. For that
# it needs room: with less than 200 MB it would do nothing else. Its regions are larger than it would choose: a job
# whose stack is larger than half of one (some thousand calls, interpreted; more, compiled) keeps a thread when it waits.
collector=
little=
for word in ${URBI_JAVA_OPTS:-} ${JAVA_TOOL_OPTIONS:-}; do
  case $word in
    -Xmx[0-9]m | -Xmx[0-9][0-9]m | -Xmx1[0-9][0-9]m) little=yes ;;
    -Xmx*) little= ;;
  esac
done
if [ "$main" = org.urbi.server.cli.UrbiCommand ] && [ -z "$little" ]; then
  for word; do
    case $word in
      --) break ;;
      -P* | --port | --port=* | --socket | --socket=*) collector="-XX:+UseG1GC -XX:MaxGCPauseMillis=10 -XX:+UnlockExperimentalVMOptions -XX:G1NewSizePercent=2 -XX:G1HeapRegionSize=8m" ;;
    esac
  done
fi
. "$root/scripts/flags.sh"
distribution_class_path
# Java takes the classes from the start-up cache without a look at the jars. One that was put there since has others.
cache=$root/$dist/urbi.aot
for jar in "$root/$dist"/lib/*.jar; do
  if [ "$jar" -nt "$cache" ] && [ -f "$cache" ]; then
    cache=
    echo "urbi: $jar is newer than the start-up cache, which is not used: build or install urbi again" >&2
    break
  fi
done
[ -f "$cache" ] || cache_flags=
# In the locale of programs that have none (cron, systemd, containers) Java finds no file whose name is not ASCII, not
# even its own. That locale has a twin with UTF-8.
case ${LC_ALL:-${LC_CTYPE:-${LANG:-C}}} in
  C | POSIX)
    [ -z "${LC_ALL:-}" ] || { LC_ALL=C.UTF-8 && export LC_ALL; }
    LC_CTYPE=C.UTF-8 && export LC_CTYPE ;;
esac
# A closed descriptor would be that of the next file that Java opens.
[ -e /dev/fd/0 ] || exec </dev/null
[ -e /dev/fd/1 ] || exec >/dev/null
[ -e /dev/fd/2 ] || exec 2>/dev/null
typing=false
[ -t 0 ] && typing=true
# Programs that urbi starts find its sister tools, after all others.
PATH=${PATH:+$PATH:}$root:$root/bin
export PATH
if [ -n "${URBI_SHOW_COMMAND:-}" ]; then # by programs that start the JVM themselves: a word a line
  # shellcheck disable=SC2086
  printf '%s\n' "$java" $jvm_flags ${URBI_JAVA_OPTS:-} "-Durbi.root=${URBI_ROOT:-$root}" \
    "-Durbi.uobjects=$root/$dist/uobjects" -Durbi.stdin.terminal=$typing "-Durbi.program=$0" -cp "$cp"
  exit
fi
# shellcheck disable=SC2086
exec "$java" $jvm_flags $cache_flags ${cache_flags:+"-XX:AOTCache=$cache"} ${URBI_JAVA_OPTS:-} -Durbi.root="${URBI_ROOT:-$root}" \
  -Durbi.uobjects="$root/$dist/uobjects" -Durbi.stdin.terminal=$typing -Durbi.program="$0" -cp "$cp" "$main" "$@"
