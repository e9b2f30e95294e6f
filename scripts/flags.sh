# The JVM's flags and class path; sourced by scripts/launch.sh and scripts/warm-up.sh, which must agree
# or the start-up cache does not fit.
jvm_flags="--add-opens java.base/java.lang=ALL-UNNAMED --enable-native-access=ALL-UNNAMED -XX:+UseSerialGC -XX:+UseCompactObjectHeaders -XX:-UsePerfData -Djdk.trackAllThreads=false -Xlog:disable"

class_path() { # DISTRIBUTION: sets cp, always in the same order
  cp=
  for jar in "$1"/lib/*.jar; do
    cp=$cp${cp:+:}$jar
  done
}
