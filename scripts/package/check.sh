#!/usr/bin/env bash
# check.sh: installs what scripts/packages has made, each into a root folder that has a shell and a libc and nothing else,
# in a path with spaces and letters that are not ASCII where that can be chosen; runs a script and a component in
# Java and in C++ there, as a user who is not root; and removes it. Called by ./check --packages, as root.
set -Eeuo pipefail
top=$(cd "$(dirname "$0")/../.." && pwd -P)
cd "$top"
# shellcheck source=scripts/jdk.sh
. scripts/jdk.sh
find_jdk
say() { echo "check: $*" >&2; }
[ "$(id -u)" = 0 ] || { say "packages are tried in roots of their own, which takes root"; exit 2; }

PATH=$PATH:/usr/sbin:/sbin
chroot=$(command -v chroot)
work=$(mktemp -d)
mounted=()
finish() {
  local each
  for each in "${mounted[@]}"; do umount -l "$each" 2>/dev/null || true; done
  rm -rf "$work"
}
trap finish EXIT
trap 'say "line $LINENO: $BASH_COMMAND"' ERR
trap 'exit 130' INT TERM

# The copied libraries include what C++ components need.
libraries() { # FILE…: what they are linked with
  ldd "$@" | grep -o '/[^ ]*' | grep -v ':$' | sort -u
}

devices() { # ROOT
  mkdir -p "$1"/{dev,proc}
  mount -t proc proc "$1/proc"
  mounted+=("$1/proc")
  mknod -m 666 "$1/dev/null" c 1 3
  mknod -m 666 "$1/dev/urandom" c 1 9
  ln -s /proc/self/fd "$1/dev/fd"
}

empty_root() { # NAME: an empty root, with a shell, a libc and a folder of a user
  local here=$work/$1 shell library
  mkdir -p "$here"/{bin,tmp,"home/Zoë M"}
  shell=$(readlink -f "$(command -v dash || command -v sh)")
  cp "$shell" "$here/bin/sh"
  for library in $(libraries "$shell" "$java" "${java%/bin/java}/lib/server/libjvm.so" "$work/motor.so"); do
    case $library in *jvm* | *jdk* | *java*) ;; *) cp -L --parents "$library" "$here/" ;; esac
  done
  # Every libc brings this locale.
  mkdir -p "$here/usr/lib/locale"
  cp -R /usr/lib/locale/C.utf8 "$here/usr/lib/locale/"
  devices "$here"
  chmod 1777 "$here/tmp"
  chown 1234:1234 "$here/home/Zoë M"
}

inside() { # ROOT COMMAND…: as a user who has no name, no HOME, no locale and may write nothing but his folder
  local here=$1
  shift
  env -i PATH=/usr/bin:/bin "$chroot" --userspec=1234:1234 "$here" "$@" </dev/null
}

equal() { # WANTED GOT WHAT
  [ "$1" = "$2" ] || { say "$3: wanted $1, got $2"; exit 1; }
}

components() { # ROOT URBI BIN
  local here=$1 urbi=$2 bin=$3 home="/home/Zoë M" out
  out=$(inside "$here" "$urbi" -q -e 'echo("Hello, World!");' -e 'shutdown;' | sed 's/^\[[0-9]*\]/[]/')
  equal '[] *** Hello, World!' "$out" hello
  cp -r examples/uobjects/machine.uob "$here$home/"
  inside "$here" "$bin/umake-java" -q "$home/machine.uob" -o "$home/machine"
  out=$(inside "$here" "$urbi" -q -m "$home/machine.jar" -e 'UMachine.assemble([12, 34]);' -e 'shutdown;' | cut -c12-)
  equal '"1234"' "$out" "a component in Java"
  cp "$work/motor.so" "$here$home/"
  out=$(inside "$here" "$urbi" -q -m "$home/motor.so" -e 'Motor.add(2);' -e 'shutdown;' | cut -c12-)
  equal 2 "$out" "a component in C++"
  out=$(inside "$here" "$urbi" -q --isolate -m "$home/motor.so" -e 'Motor.add(2);' -e 'shutdown;' | cut -c12-)
  equal 2 "$out" "a component in C++ in a process of its own"
  out=$(inside "$here" "$urbi" -q -m sim -e 'echo(isdef(SimWorld));' -e 'shutdown;' 2>&1 | cut -c12-)
  equal '*** true' "$out" "the simulated robot"
}

milliseconds() { # COMMAND…: of the processor, whatever else the machine does; the fastest of five starts
  local best=999999 user system i TIMEFORMAT='%3U %3S'
  for i in 1 2 3 4 5; do
    read -r user system < <({ time "$@" -q -e 'shutdown;' </dev/null >/dev/null; } 2>&1)
    i=$((10#${user/./} + 10#${system/./}))
    [ "$i" -ge "$best" ] || best=$i
  done
  echo "$best"
}

. ./.build/current
version=$(sed -n 's|^  <version>\(.*\)</version>$|\1|p' pom.xml)
packages=$top/.build/packages
archive=$(echo "$packages"/urbi-"$version"-*.tar.gz)
size=$(stat -c %s "$archive")
[ "$size" -le $((60 << 20)) ] || { say "the archive has $((size >> 20)) MB, which is more than 60"; exit 1; }

say "the archive"
place=$work/unpacked
mkdir "$place"
tar -xzf "$archive" -C "$place"
unpacked=$(echo "$place"/*)
# A component in C++ is compiled where there is a compiler, by CMake and by pkg-config, with what the archive has.
project="$work/Übung 1"
mkdir "$project"
(cd "$project" && "$unpacked/urbi" new --cxx motor && cd motor && cmake -B build && cmake --build build &&
  ctest --test-dir build) >"$work/cmake.log" 2>&1 || { cat "$work/cmake.log" >&2; exit 1; }
cp "$project/motor/build/motor.so" "$work/"
# One in Java by Maven, from what the build of urbi has fetched already.
(cd "$project" && "$unpacked/urbi" new thermo && cd thermo && run_maven -o -q verify) >"$work/maven.log" 2>&1 ||
  { cat "$work/maven.log" >&2; exit 1; }
[ -s "$project/thermo/target/thermo.jar" ]
# A test that fails is told.
sed -i 's/ == 2/ == 3/' "$project/thermo/src/test/urbi/thermo.u"
if (cd "$project/thermo" && run_maven -o -q verify) >"$work/maven.log" 2>&1; then say "a test that fails passes"; exit 1; fi
grep -q 'failed assertion' "$work/maven.log"
# The example of embedding, as its page says: it prints what that page has below "It prints".
out=$(cd "$project" && "$jdk/bin/java" -cp "$("$unpacked/urbi" --print-root)/dist/lib/*" --source 25 \
  "$unpacked/examples/embedding/Embed.java" 2>&1)
equal "$(sed -n '/^It prints$/,$s/^    //p' examples/embedding/README.md)" "$out" "the example of embedding"
(export PKG_CONFIG_PATH="$unpacked/share/pkgconfig"
  # shellcheck disable=SC2046
  g++ $(pkg-config --cflags urbi) -shared -o "$work/point.so" "$top"/examples/uobjects-cpp/point.uob/*.cc $(pkg-config --libs urbi))
moved="/opt/Größe 1"
empty_root one
mkdir -p "$work/one$moved"
tar -xzf "$archive" -C "$work/one$moved"
name=$(basename "$unpacked")
chmod -R a-w "$work/one$moved"
components "$work/one" "$moved/$name/urbi" "$moved/$name/bin"
# Nothing was written into what may not be written, and all that there is came from the archive.
equal "$(tar -tzf "$archive" | grep -vc '/$')" "$(find "$work/one$moved" ! -type d | wc -l)" "the number of files"
# A start costs what it costs in the checkout: the cache is used though the folder was moved.
own=$(milliseconds ./urbi)
theirs=$(milliseconds "$work/one$moved/$name/urbi")
say "start: $theirs ms of the processor, in the checkout $own ms"
[ "$theirs" -le $((own * 5 / 4 + 10)) ] || { say "the archive starts more slowly than the checkout"; exit 1; }
# A cache that does not fit costs time and nothing else.
find "$work/one$moved/$name/dist/lib" -exec touch {} +
out=$("$work/one$moved/$name/urbi" -q -e 'echo(1);' -e 'shutdown;' </dev/null | cut -c12-)
equal '*** 1' "$out" "with a cache that does not fit"
# Half an installation says so.
rm "$work/one$moved/$name/runtime/bin/java"
out=$("$work/one$moved/$name/urbi" --version 2>&1) && exit 1
case $out in *"install urbi again"*) ;; *) say "half an installation: $out"; exit 1 ;; esac
rm -rf "$work/one$moved"

say "the documentation, and its search"
chromium --headless --no-sandbox --disable-gpu --virtual-time-budget=20000 --dump-dom \
  "file://$unpacked/share/doc/urbi/html/index.html?q=barrier+signal" >"$work/found.html" 2>"$work/chromium.log" ||
  { cat "$work/chromium.log" >&2; exit 1; }
grep -q '<a href="library/Barrier.html#signal-signalall">' "$work/found.html" || { say "the search does not find Barrier.signal"; exit 1; }

say "the package for Debian"
empty_root two
# Debian always has it; links are followed by it.
cp "$(readlink -f "$(command -v readlink)")" "$work/two/bin/"
mkdir -p "$work/two/var/lib/dpkg"/{info,updates}
touch "$work/two/var/lib/dpkg"/{status,available}
before=$(find "$work/two" -xdev | grep -v -e /var/lib/dpkg -e /proc/ | sort)
dpkg --root="$work/two" --force-depends -i "$packages"/urbi_"$version"_*.deb >"$work/dpkg.log" 2>&1 ||
  { cat "$work/dpkg.log" >&2; exit 1; }
components "$work/two" /usr/bin/urbi /usr/bin
for page in "$work"/two/usr/share/man/man1/*.gz; do
  gzip -t "$page"
done
for script in "$work"/two/usr/share/bash-completion/completions/*; do
  bash -n "$script"
done
rm -rf "$work/two/home/Zoë M"/*
dpkg --root="$work/two" --force-depends -P urbi >"$work/dpkg.log" 2>&1
after=$(find "$work/two" -xdev | grep -v -e /var/lib/dpkg -e /var/log -e /proc/ | sort)
equal "$before" "$after" "what is left when the package was removed"

say "the container image"
mkdir -p "$work/oci" "$work/three"
tar -xf "$packages"/urbi-"$version"-*.oci.tar -C "$work/oci"
for blob in "$work"/oci/blobs/sha256/*; do
  equal "${blob##*/}" "$(sha256sum <"$blob" | cut -d' ' -f1)" "the hash of a blob"
done
hashes() { grep -o 'sha256:[0-9a-f]*' "$1" | cut -d: -f2; }
manifest=$work/oci/blobs/sha256/$(hashes "$work/oci/index.json")
# It names the configuration, and then the only layer.
layer=$work/oci/blobs/sha256/$(hashes "$manifest" | tail -n 1)
config=$work/oci/blobs/sha256/$(hashes "$manifest" | head -n 1)
equal "$(hashes "$config")" "$(gzip -dc "$layer" | sha256sum | cut -d' ' -f1)" "the hash of the unpacked layer"
tar -xzf "$layer" -C "$work/three"
devices "$work/three"
contained() { # COMMAND…: as the configuration of the image has it run
  env -i PATH=/usr/bin:/bin HOME=/home/urbi LANG=C.UTF-8 "$chroot" --userspec=1000:1000 "$work/three" "$@" </dev/null
}
out=$(contained urbi -q -e 'echo("Hello, World!");' -e 'shutdown;' | cut -c12-)
equal '*** Hello, World!' "$out" "the container's entry point"
cp -r examples/uobjects/machine.uob "$work/motor.so" "$work/three/home/urbi/"
contained umake-java -q /home/urbi/machine.uob -o /home/urbi/machine
out=$(contained urbi -q -m /home/urbi/machine.jar -e 'UMachine.assemble([12, 34]);' -e 'shutdown;' | cut -c12-)
equal '"1234"' "$out" "a component in Java in the container"
out=$(contained urbi -q -m /home/urbi/motor.so -e 'Motor.add(2);' -e 'shutdown;' | cut -c12-)
equal 2 "$out" "a component in C++ in the container"
say "the artifacts for Maven"
repository=$packages/maven-repository/org/urbi
for library in urbi-lang urbi-builtins uobject-java urbi-kernel uobject-native-bridge urbi-web urbi-server sim-devices urbi-ros; do
  base=$repository/$library/$version/$library-$version
  for file in "$base".pom "$base".jar "$base"-sources.jar "$base"-javadoc.jar; do
    [ -s "$file" ] || { say "no ${file##*/}"; exit 1; }
  done
  unzip -p "$base.jar" META-INF/MANIFEST.MF | grep '^Automatic-Module-Name: [a-z]' >/dev/null || { say "$library has no name as a module"; exit 1; }
  unzip -l "$base-javadoc.jar" index.html >/dev/null || { say "$library has no Javadoc"; exit 1; }
  grep -q "<artifactId>$library</artifactId><version>$version<" "$repository/urbi-bom/$version/urbi-bom-$version.pom" ||
    { say "urbi-bom has no $library"; exit 1; }
  grep -q '<name>.*' "$base.pom" && grep -q '<description>' "$base.pom" || { say "$library says too little of itself"; exit 1; }
done
for wanted in "<project.home>${URBI_HOME_PAGE:-https://not-published.invalid/urbi}<" '<url>' '<licenses>' '<developers>' '<scm '; do
  grep -q "$wanted" "$repository/urbi/$version/urbi-$version.pom" || { say "the main pom has no $wanted"; exit 1; }
done
# A project that the archetype makes builds, tests itself and runs.
cat >"$work/settings.xml" <<EOF
<settings>
  <profiles>
    <profile>
      <id>packages</id>
      <repositories><repository><id>archetype</id><url>file://$packages/maven-repository</url></repository></repositories>
    </profile>
  </profiles>
  <activeProfiles><activeProfile>packages</activeProfile></activeProfiles>
</settings>
EOF
(cd "$project" && run_maven -q -gs "$work/settings.xml" org.apache.maven.plugins:maven-archetype-plugin:3.4.0:generate \
  -DinteractiveMode=false -DarchetypeCatalog=internal -DarchetypeGroupId=org.urbi \
  -DarchetypeArtifactId=urbi-component-archetype -DarchetypeVersion="$version" -DgroupId=org.example -DartifactId=heater \
  -Dversion=0.1.0 -Dpackage=org.example -Dcomponent=Heater -DurbiRoot="$unpacked" &&
  cd heater && run_maven -o -q verify) >"$work/maven.log" 2>&1 || { cat "$work/maven.log" >&2; exit 1; }
out=$("$unpacked/urbi" -q -m "$project/heater/target/heater.jar" -e 'Heater.add(2);' -e 'shutdown;' </dev/null | cut -c12-)
equal 2 "$out" "a component that the archetype has made"
say "the unit for systemd"
scripts/package/systemd.sh "$unpacked"
say "the extension for VS Code"
unzip -q "$packages/urbiscript-$version.vsix" -d "$work/vsix"
for file in package.json language-configuration.json syntaxes/{urbiscript,session,markdown}.tmLanguage.json snippets/urbiscript.json; do
  cmp "editors/vscode/$file" "$work/vsix/extension/$file"
done
[ ! -e "$work/vsix/extension/test" ] && [ ! -e "$work/vsix/extension/node_modules" ] || { say "the extension has what it does not need"; exit 1; }
say "packages: all was installed, run and removed"
