#!/usr/bin/env bash
# bare.sh ROOT COMMAND: runs COMMAND, as root, on a Debian 12 that has nothing else: what is missing in our lists of
# packages shows only there. ROOT is made (debootstrap) where it is missing. This repository lies at /amalgam, to be
# read and cloned. Mounts and processes end with COMMAND; the network is this machine's. For root.
#   LAYER=DIR           what changes goes to DIR, and ROOT stays as it is
#   BIND=DIR[:DIR...]   folders of this machine that are there too, to be written
#   MIRROR=URL          of Debian's packages
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
repository=$(cd "$here/../.." && pwd)
root=${1:?usage: bare.sh ROOT COMMAND}
command=${2:?usage: bare.sh ROOT COMMAND}
mirror=${MIRROR:-http://deb.debian.org/debian}

if [ ! -e "$root/etc/debian_version" ]; then
  echo "bare: $root is made" >&2
  debootstrap --variant=minbase bookworm "$root" "$mirror" >&2
  cat > "$root/etc/apt/sources.list" <<LIST
deb $mirror bookworm main
deb $mirror bookworm-updates main
deb ${mirror}-security bookworm-security main
LIST
  # All of it can be made again, so that dpkg need not wait for the disk.
  echo force-unsafe-io > "$root/etc/dpkg/dpkg.cfg.d/thrown-away"
fi

# In namespaces of its own, so that nothing stays mounted however this ends.
enter() {
  local root=$1 layer=$2 command=$3 repository=$4 binds folder
  if [ -n "$layer" ]; then
    mkdir -p "$layer"/{changes,work,merged}
    mount -t overlay overlay -o "lowerdir=$root,upperdir=$layer/changes,workdir=$layer/work" "$layer/merged"
    root=$layer/merged
  else
    mount --bind "$root" "$root"
  fi
  mount -t proc proc "$root/proc"
  mount --rbind /sys "$root/sys"
  mount --rbind /dev "$root/dev"
  mount -t tmpfs -o mode=1777 tmpfs "$root/dev/shm"
  mount -t tmpfs -o mode=1777 tmpfs "$root/tmp"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  mkdir -p "$root/amalgam"
  mount --bind "$repository" "$root/amalgam"
  mount -o remount,bind,ro "$root/amalgam"
  IFS=: read -ra binds <<< "${BIND:-}"
  for folder in "${binds[@]}"; do
    mkdir -p "$root$folder"
    mount --bind "$folder" "$root$folder"
  done
  cd "$root"
  # What the shell that asks has in its environment is not on a bare machine.
  exec chroot . /usr/bin/env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    TERM="${TERM:-dumb}" bash -c "$command"
}
export -f enter
exec unshare --mount --pid --ipc --uts --fork --kill-child bash -euo pipefail -c 'enter "$@"' enter \
  "$(realpath "$root")" "${LAYER:+$(realpath -m "$LAYER")}" "$command" "$repository"
