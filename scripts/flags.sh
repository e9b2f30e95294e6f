# The JVM's flags and class path; sourced by scripts/launch.sh and scripts/warm-up.sh, which must agree
# or the start-up cache does not fit.
# Whoever sources this sets `collector`, or has the serial one. A garbage collector in URBI_JAVA_OPTS takes its place:
# the JVM refuses to have two.
: "${collector:=-XX:+UseSerialGC}"
for word in ${URBI_JAVA_OPTS:-}; do
  case $word in
    -XX:+UseSerialGC | -XX:+UseParallelGC | -XX:+UseG1GC | -XX:+UseZGC | -XX:+UseShenandoahGC | -XX:+UseEpsilonGC)
      collector= ;;
  esac
done
# Handlers of exceptions are compiled though they have never been used: else each of the calls that an exception unwinds for
# the first time, up to 200,000, would go back to the interpreter on its own, while nobody else runs.
# Netty would tell the flight recorder of its buffers: to get ready for that takes a fifth of the time of a server's start.
# The first of the two JITs inlines nearly nothing: what Urbi compiles calls many short methods, and to inline them all takes it
# 200 ms for one long function, while all else waits to be compiled. The second, which compiles what is hot, inlines as always.
jvm_flags="--add-opens java.base/java.lang=ALL-UNNAMED --enable-native-access=ALL-UNNAMED $collector -XX:C1MaxInlineSize=6 -XX:+UseCompactObjectHeaders -XX:-UsePerfData -XX:-ProfileExceptionHandlers -Djdk.trackAllThreads=false -Dio.netty.jfr.enabled=false -Xlog:disable"

# Those of a JVM with a start-up cache, which only the JDK that has made it can use. The cache is mapped where it was made
# for (else each of its pointers is moved first); nobody looks for profiles, which it has not. What short programs call
# a few hundred times is interpreted: to compile it costs more than it saves.
cache_flags="-XX:+UnlockDiagnosticVMOptions -XX:ArchiveRelocationMode=0 -XX:-AOTReplayTraining -XX:Tier3InvocationThreshold=1000 -XX:Tier3MinInvocationThreshold=500 -XX:Tier3CompileThreshold=5000"

# Our own jars come first: Java opens all of them until it has found a file or a class that is not in the cache.
class_path() { # DISTRIBUTION: sets cp, always in the same order; what a package adds comes last, for the cache
  cp=
  for jar in "$1"/lib/u*.jar "$1"/lib/[!u]*.jar "$1"/opencv/*.jar; do
    [ ! -f "$jar" ] || cp=$cp${cp:+:}$jar
  done
}

# A package, whose distribution is in dist, may be moved after its cache was made. Of each class in it Java asks where its
# jar was then, and where nothing is there any more it asks in vain, class by class, for a third of the time of a start. So
# the jars of a package are named by an open descriptor of their folder, whose name is the same everywhere; Java's processes
# do not pass it on, and it means nothing to who only wants to see the command.
distribution_class_path() { # of root and dist: sets cp
  if [ "$dist" = dist ] && [ -z "${URBI_SHOW_COMMAND:-}" ] && [ -d /proc/self/fd ] && [ -r "$root/dist" ]; then
    exec 9<"$root/dist"
    class_path /proc/self/fd/9
  else
    class_path "$root/$dist"
  fi
}
