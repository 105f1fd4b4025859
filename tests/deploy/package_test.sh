#!/bin/sh
# The Debian package is made, holds what it should, and lintian finds no error. Exits with 77 where lintian is missing.
set -eu
build=${1:?usage: package_test.sh BUILD}
if ! command -v lintian >/dev/null || ! command -v help2man >/dev/null; then
  printf 'Skipped\nlintian or help2man is not installed\n'
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
(cd "$build" && cpack -G DEB -B "$folder") >"$folder/log" || { cat "$folder/log"; exit 1; }
package=$(echo "$folder"/*.deb)
lintian --fail-on error "$package"
dpkg-deb -c "$package" >"$folder/list"
for file in ./usr/bin/amalgam-server ./etc/amalgam/server.toml ./usr/lib/systemd/system/amalgam.service \
  ./usr/share/man/man1/amalgam-server.1.gz ./usr/share/man/man1/amalgam-client.1.gz \
  ./usr/share/amalgam/scenes/complex.gltf; do
  grep -q " $file$" "$folder/list" || { echo "$file is missing"; exit 1; }
done
# An upgrade must keep what the operator wrote.
dpkg-deb --info "$package" conffiles | grep -qx /etc/amalgam/server.toml
