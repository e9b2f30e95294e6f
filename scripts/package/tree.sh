# Sourced by scripts/packages: the folder that every package of programs contains. It needs nothing but a libc and a
# shell, and may be moved: all that it has of its own place is found from where the launcher is.

# The modules of the JDK that the jars, umake-java (jdk.compiler) and components may use.
modules=java.desktop,java.logging,java.management,java.naming,java.net.http,java.scripting,java.sql
modules+=,jdk.compiler,jdk.crypto.ec,jdk.management,jdk.net,jdk.unsupported,jdk.zipfs

make_runtime() { # FOLDER
  # ct.sym is for compiling for another Java than this one, and a fifth of the whole.
  "$jdk/bin/jlink" --add-modules "$modules" --no-header-files --no-man-pages --strip-java-debug-attributes \
    --exclude-files='/jdk.compiler/lib/ct.sym,/java.base/lib/jrt-fs.jar' --output "$1" >"$made/work/jlink.log" 2>&1 ||
    { cat "$made/work/jlink.log" >&2; return 1; }
  rm -f "$1"/bin/{jrunscript,keytool,serialver,javac}
}

make_tree() { # FOLDER OPENCV: OpenCV's libraries are a package of their own
  local tree=$1 opencv=$2 jar
  say "collecting files…"
  mkdir -p "$tree"/{dist/lib,scripts,bin,share,include} "$opencv/dist/opencv"
  make_runtime "$tree/runtime"
  for jar in "$dist"/lib/*.jar; do
    case ${jar##*/} in
      opencv-*-"$platform".jar | openblas-*) cp "$jar" "$opencv/dist/opencv/" ;;
      *) cp "$jar" "$tree/dist/lib/" ;;
    esac
  done
  cp -R "$dist/uobjects" "$dist/bom.json" "$dist/bom.xml" "$dist/THIRD-PARTY.txt" "$tree/dist/"
  cp urbi LICENSE README.md CHANGELOG.md "$tree/"
  cp bin/* "$tree/bin/"
  cp scripts/{launch.sh,flags.sh,umake-kept.sh} "$tree/scripts/"
  cp -R share/. "$tree/share/"
  cp -R include/. "$tree/include/"
  mkdir -p "$tree/share/emacs/site-lisp"
  cp editors/emacs/urbiscript-mode.el "$tree/share/emacs/site-lisp/"
  cp -R docs "$tree/"
  mkdir -p "$tree/share/doc/urbi"
  cp -R "$site" "$tree/share/doc/urbi/html"
  git ls-files -z examples | xargs -0 cp --parents -t "$tree/"
  make_manual "$tree"
  chmod -R u+rwX,go+rX,go-w "$tree" "$opencv"
  # The cache fits only jars with the times that they had when it was made.
  find "$tree" "$opencv" -exec touch -h -d "@$epoch" {} +
  say "making the start-up cache…"
  scripts/warm-up.sh "$tree" dist "$tree/runtime/bin/java" "$made/work/warm-up.log" ||
    { tail -n 20 "$made/work/warm-up.log" >&2; return 1; }
  touch -d "@$epoch" "$tree/dist/urbi.aot" "$tree/dist"
}

# Man pages and completion, of the declarations of the options; umake's of its help.
make_manual() { # FOLDER
  local classes man=$1/share/man/man1
  classes=$(printf '%s:' "$1"/dist/lib/*.jar)
  "$1/runtime/bin/java" -XX:TieredStopAtLevel=1 -XX:+UseSerialGC -cp "$classes" \
    org.urbi.server.manual.ManualPages "$1/share"
  {
    printf '.TH UMAKE 1 "" "urbi %s" "Urbi on the JVM"\n.SH NAME\n' "$version"
    printf 'umake \\- compiles UObjects written in C++\n.SH DESCRIPTION\n.nf\n'
    bin/umake --help | sed 's/\\/\\e/g; s/-/\\-/g; s/^[.'"'"']/\\\&&/'
  } >"$man/umake.1"
  echo .so man1/umake.1 >"$man/umake-shared.1"
  echo .so man1/umake.1 >"$man/umake-deepclean.1"
}
