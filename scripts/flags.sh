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
jvm_flags="--add-opens java.base/java.lang=ALL-UNNAMED --enable-native-access=ALL-UNNAMED $collector -XX:+UseCompactObjectHeaders -XX:-UsePerfData -Djdk.trackAllThreads=false -Xlog:disable"

class_path() { # DISTRIBUTION: sets cp, always in the same order; what a package adds comes last, for the cache
  cp=
  for jar in "$1"/lib/*.jar "$1"/opencv/*.jar; do
    [ ! -f "$jar" ] || cp=$cp${cp:+:}$jar
  done
}
