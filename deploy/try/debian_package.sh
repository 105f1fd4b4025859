#!/usr/bin/env bash
# debian_package.sh ROOT DEB: does the package work where nothing else is? Installs it with apt on the bare Debian of
# ROOT (bare.sh), lets its programs work together, as users who own nothing, on a file system that nobody can write,
# and removes it again. Needs debootstrap and root.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=${1:?usage: debian_package.sh ROOT DEB}
deb=$(realpath "${2:?usage: debian_package.sh ROOT DEB}")
layer=$(mktemp -d)
trap 'rm -rf "$layer"' EXIT
mkdir "$layer/given"
cp "$deb" "$here/inside_package.sh" "$layer/given"
LAYER=$layer/root BIND=$layer/given "$here/bare.sh" "$root" "bash $layer/given/inside_package.sh $layer/given/*.deb"
