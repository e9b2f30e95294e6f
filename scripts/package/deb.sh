# Sourced by scripts/packages: urbi and urbi-opencv for Debian, Ubuntu and their kin. The whole is in /usr/lib/urbi,
# with links to it from where programs, manuals and other tools look for such things.
command -v dpkg-deb >/dev/null || { say "no dpkg-deb: apt-get install dpkg"; exit 1; }

control() { # FOLDER PACKAGE DEPENDS COMPRESSION DESCRIPTION…: the control files, and the package
  local folder=$1 package=$2 depends=$3 compression=$4 size
  shift 4
  mkdir -p "$folder/usr/share/doc/$package" "$folder/DEBIAN"
  cp LICENSE "$folder/usr/share/doc/$package/copyright"
  size=$(du -sk "$folder" | cut -f1)
  cat >"$folder/DEBIAN/control" <<EOF
Package: $package
Version: $version
Architecture: $debian
Maintainer: ${DEBFULLNAME:-the Urbi on the JVM authors} <${DEBEMAIL:-nobody@not-published.invalid}>
Homepage: $home
Section: devel
Priority: optional
Installed-Size: $size
Depends: $depends
Description: $1
$(printf ' %s\n' "${@:2}")
EOF
  (cd "$folder" && find usr -type f -print0 | LC_ALL=C sort -z | xargs -0 md5sum) >"$folder/DEBIAN/md5sums"
  chmod -R u+rwX,go+rX,go-w "$folder"
  find "$folder" -newermt "@$epoch" -exec touch -h -d "@$epoch" {} +
  SOURCE_DATE_EPOCH=$epoch dpkg-deb --root-owner-group "-Z$compression" -z1 --build "$folder" \
    "$made/${package}_${version}_$debian.deb" >/dev/null
  finished "$made/${package}_${version}_$debian.deb"
}

say "making packages for Debian…"
deb=$made/work/deb/urbi
mkdir -p "$deb/usr/lib" "$deb/usr/bin" "$deb/usr/share/"{man,bash-completion/completions,zsh/vendor-completions,pkgconfig,cmake/Urbi,emacs,doc/urbi}
cp -a "$made/work/$name" "$deb/usr/lib/urbi"
ln -s ../lib/urbi/urbi "$deb/usr/bin/urbi"
for program in bin/*; do
  ln -s "../lib/urbi/$program" "$deb/usr/bin/${program##*/}"
done
mv "$deb/usr/lib/urbi/share/man/man1" "$deb/usr/share/man/man1"
gzip -9n "$deb"/usr/share/man/man1/*
mv "$deb"/usr/lib/urbi/share/bash-completion/completions/* "$deb/usr/share/bash-completion/completions/"
mv "$deb"/usr/lib/urbi/share/zsh/site-functions/* "$deb/usr/share/zsh/vendor-completions/"
mv "$deb/usr/lib/urbi/share/emacs/site-lisp" "$deb/usr/share/emacs/"
mv "$deb/usr/lib/urbi/share/doc/urbi/html" "$deb/usr/share/doc/urbi/"
rm -r "$deb"/usr/lib/urbi/share/{man,bash-completion,zsh,emacs,doc}
sed 's|^prefix=.*|prefix=/usr/lib/urbi|' share/pkgconfig/urbi.pc >"$deb/usr/share/pkgconfig/urbi.pc"
for file in share/cmake/Urbi/*; do
  ln -s "../../../lib/urbi/$file" "$deb/usr/share/cmake/Urbi/${file##*/}"
done
control "$deb" urbi "libc6 (>= 2.17)" xz "urbiscript, the orchestration language for robots" \
  "Runs programs in urbiscript, the language of Urbi 2.7 for parallel and event-driven" \
  "programs; serves clients; has components in Java and C++ plugged in. It has a Java" \
  "runtime of its own. Components in C++ need g++ and make to be compiled."

deb=$made/work/deb/urbi-opencv
mkdir -p "$deb/usr/lib"
cp -a "$made/work/opencv/$name" "$deb/usr/lib/urbi"
control "$deb" urbi-opencv "urbi (= $version)" none "OpenCV for urbi" \
  "The libraries of OpenCV, with which simulated cameras find what they see."
