# Sourced by scripts/packages: a container image as an archive in the form of OCI, for `podman load`, `docker load`,
# `skopeo copy oci-archive:…`. It is made from scratch, of the package and the libc and shell of this machine: no
# image of others is fetched, and what is in it can be counted.
say "making a container image…"
image=$made/work/image
layer=$image/layer
mkdir -p "$layer"/{bin,etc,tmp,usr/bin,usr/lib,home/urbi} "$image/oci/blobs/sha256"
cp -a "$made/work/$name" "$layer/usr/lib/urbi"
rm -rf "$layer"/usr/lib/urbi/{docs,include,examples,share/man,share/systemd,share/zsh,share/bash-completion,share/emacs,share/doc}
# No links: to follow them takes readlink, which is not there.
for program in urbi bin/urbi-send bin/urbi-launch bin/urbi-launch-java bin/umake-java bin/urbi-ping; do
  printf '#!/bin/sh\nexec /usr/lib/urbi/%s "$@"\n' "$program" >"$layer/usr/bin/${program##*/}"
  chmod 755 "$layer/usr/bin/${program##*/}"
done
# The shell that the launcher is run by, and the libraries that it and Java need.
shell=$(readlink -f "$(command -v dash || command -v sh)")
cp "$shell" "$layer/bin/sh"
for file in "$shell" runtime/bin/java runtime/lib/server/libjvm.so runtime/lib/libnio.so; do
  case $file in runtime/*) file=$layer/usr/lib/urbi/$file ;; esac
  ldd "$file"
done | grep -o '/[^ ]*' | sort -u | while IFS= read -r library; do
  case $library in "$layer"*) continue ;; esac
  cp -L --parents "$library" "$layer/"
done
# What looks up names of hosts and users is found when it is asked; the others are for components in C++.
for library in libnss_files.so.2 libnss_dns.so.2 libresolv.so.2 libstdc++.so.6 libgcc_s.so.1 libm.so.6; do
  for file in "/lib/$(uname -m)-linux-gnu/$library"; do
    [ ! -e "$file" ] || cp -L --parents "$file" "$layer/"
  done
done
cp -R --parents /usr/lib/locale/C.utf8 "$layer/"
echo 'root:x:0:0:root:/:/bin/sh
urbi:x:1000:1000:urbi:/home/urbi:/bin/sh' >"$layer/etc/passwd"
echo 'root:x:0:
urbi:x:1000:' >"$layer/etc/group"
echo 'hosts: files dns' >"$layer/etc/nsswitch.conf"
chmod 1777 "$layer/tmp"
find "$layer" -newermt "@$epoch" -exec touch -h -d "@$epoch" {} +

blobs=$image/oci/blobs/sha256
blob() { # FILE: puts it among the blobs, prints its hash and size
  local sum size
  sum=$(sha256sum "$1" | cut -d' ' -f1)
  size=$(stat -c %s "$1")
  mv "$1" "$blobs/$sum"
  echo "$sum $size"
}
tar -C "$layer" --sort=name --owner=0 --group=0 --numeric-owner -cf "$image/layer.tar" --exclude=./home/urbi .
# Its home is the user's.
tar -C "$layer" --owner=1000 --group=1000 --numeric-owner -rf "$image/layer.tar" ./home/urbi
unpacked=$(sha256sum "$image/layer.tar" | cut -d' ' -f1)
gzip -9n "$image/layer.tar"
read -r layer_sum layer_size < <(blob "$image/layer.tar.gz")
created=$(date -u -d "@$epoch" +%Y-%m-%dT%H:%M:%SZ)
cat >"$image/config" <<EOF
{"created":"$created","architecture":"$machine","os":"linux",
 "config":{"User":"1000:1000","WorkingDir":"/home/urbi","Entrypoint":["/usr/bin/urbi"],
  "Env":["PATH=/usr/bin:/bin","HOME=/home/urbi","LANG=C.UTF-8"],
  "Labels":{"org.opencontainers.image.title":"urbi","org.opencontainers.image.version":"$version"}},
 "rootfs":{"type":"layers","diff_ids":["sha256:$unpacked"]}}
EOF
read -r config_sum config_size < <(blob "$image/config")
cat >"$image/manifest" <<EOF
{"schemaVersion":2,"mediaType":"application/vnd.oci.image.manifest.v1+json",
 "config":{"mediaType":"application/vnd.oci.image.config.v1+json","digest":"sha256:$config_sum","size":$config_size},
 "layers":[{"mediaType":"application/vnd.oci.image.layer.v1.tar+gzip","digest":"sha256:$layer_sum","size":$layer_size}]}
EOF
read -r manifest_sum manifest_size < <(blob "$image/manifest")
cat >"$image/oci/index.json" <<EOF
{"schemaVersion":2,"mediaType":"application/vnd.oci.image.index.v1+json",
 "manifests":[{"mediaType":"application/vnd.oci.image.manifest.v1+json","digest":"sha256:$manifest_sum","size":$manifest_size,
  "annotations":{"org.opencontainers.image.ref.name":"urbi:$version"}}]}
EOF
echo '{"imageLayoutVersion":"1.0.0"}' >"$image/oci/oci-layout"
tar_of "$image/oci" blobs index.json oci-layout >"$made/urbi-$version-$platform.oci.tar"
finished "$made/urbi-$version-$platform.oci.tar"
