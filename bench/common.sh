# Sourced by run, startup, jmh and soak: builds what is missing or old, and starts a class of this
# module on the distribution's jars.
root=$(cd "$(dirname "$0")/.." && pwd -P)
cd "$root" || exit 1
# shellcheck source=../scripts/jdk.sh
. scripts/jdk.sh
# shellcheck source=../scripts/flags.sh
. scripts/flags.sh

build_if_needed() {
  ./build --if-needed || exit 1
  # shellcheck disable=SC1091
  . .build/current
  if [ ! -f bench/target/lib/ready ] ||
      [ -n "$(find bench/pom.xml bench/src .build/current -newer bench/target/lib/ready -print -quit)" ]; then
    find_jdk && find_maven || exit 1
    echo "bench: building the benchmarks" >&2
    run_maven -q -pl bench -am -DskipTests package >&2 || exit 1
    touch bench/target/lib/ready
  fi
}

# start MAIN ARGUMENT…: the class path is the distribution's, then this module's.
start() {
  class_path "$root/$dist"
  cp=$cp:$root/bench/target/classes
  for jar in "$root/$dist"/uobjects/*.jar "$root/$dist"/uobjects/urbi/*.jar "$root"/bench/target/lib/*.jar; do
    cp=$cp:$jar
  done
  # shellcheck disable=SC2086
  exec "$java" $jvm_flags ${BENCH_JAVA_OPTS:-} -Dbench.root="$root" -Dbench.jvm.flags="$jvm_flags" \
    -cp "$cp" "$@"
}
