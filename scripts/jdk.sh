# Finds a JDK 25 or later; sourced by ./build and ./check. Sets `jdk`, or says what to install.
# A JDK says its version in the file `release`, so that none has to be started to ask.

jdk_version() { # HOME: prints the major version, 0 if there is no usable JDK
  [ -x "$1/bin/javac" ] && [ -r "$1/release" ] || { echo 0; return; }
  sed -n 's/^JAVA_VERSION="\([0-9]*\).*/\1/p' "$1/release" | head -n 1 | grep . || echo 0
}

find_jdk() {
  jdk=
  on_path=$(command -v javac 2>/dev/null) && on_path=$(readlink -f "$on_path" 2>/dev/null)
  for home in "${URBI_JAVA_HOME:-}" "${JAVA_HOME:-}" "${on_path%/bin/javac}" \
      /usr/lib/jvm/* /opt/*jdk* /opt/java/* "$HOME"/.sdkman/candidates/java/* "$HOME"/.jdks/* \
      /Library/Java/JavaVirtualMachines/*/Contents/Home; do
    [ -n "$home" ] || continue
    if [ "$(jdk_version "$home")" -ge 25 ]; then
      jdk=$home
      return 0
    fi
  done
  cat >&2 <<EOF
urbi: a JDK 25 or later is needed, and there is none in JAVA_HOME, on the PATH or in the usual places.
urbi: install one, for instance:
urbi:   Debian, Ubuntu   apt-get install temurin-25-jdk   (or openjdk-25-jdk where there is one)
urbi:   Fedora           dnf install java-25-openjdk-devel
urbi:   macOS            brew install openjdk@25
urbi:   anywhere         sdk install java 25-tem          (SDKMAN)
urbi: or set URBI_JAVA_HOME to the folder of one that is already installed.
EOF
  return 1
}

find_maven() {
  command -v mvn >/dev/null 2>&1 && return 0
  cat >&2 <<EOF
urbi: Maven 3.8 or later is needed to build, and there is no mvn on the PATH.
urbi: install it, for instance: apt-get install maven, dnf install maven, brew install maven.
EOF
  return 1
}

# Maven on the JDK found (spotless needs that), without the warnings about Maven's own jars.
run_maven() {
  JAVA_HOME=$jdk \
  MAVEN_OPTS="--enable-native-access=ALL-UNNAMED --sun-misc-unsafe-memory-access=allow ${MAVEN_OPTS:-}" \
    mvn -B "$@"
}
