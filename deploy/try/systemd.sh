#!/usr/bin/env bash
# systemd.sh ROOT DEB: does the unit do what it says? Installs the package on the bare Debian of ROOT (bare.sh), boots
# that with systemd as process 1, and runs inside_systemd.py there. Its network is its own. Needs debootstrap,
# systemd-container and root; works without systemd on this machine.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(realpath "${1:?usage: systemd.sh ROOT DEB}")
deb=$(realpath "${2:?usage: systemd.sh ROOT DEB}")
layer=$(mktemp -d)
group=amalgam-try-$$
trap 'rm -rf "$layer"' EXIT
mkdir "$layer/given"
cp "$deb" "$layer/given/amalgam.deb"
cp "$here/inside_systemd.py" "$layer/given"
LAYER=$layer/root BIND=$layer/given "$here/bare.sh" "$root" "set -e; apt-get update -qq
  DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends systemd-sysv iproute2 python3 $layer/given/amalgam.deb > /dev/null
  ! systemctl is-enabled -q amalgam || { echo 'systemd.sh: installed is not enabled' >&2; exit 1; }
  : > /etc/machine-id  # new, but no first boot, which would enable all units
  mkdir /given && cp $layer/given/* /given
  cat > /etc/systemd/system/inside.service <<UNIT
[Unit]
After=multi-user.target
[Service]
Type=oneshot
TimeoutStartSec=15min
ExecStart=/usr/bin/python3 -u /given/inside_systemd.py
StandardOutput=file:/said
StandardError=inherit
ExecStopPost=/bin/sh -c 'systemctl exit \\\$EXIT_STATUS'
[Install]
WantedBy=multi-user.target
UNIT
  systemctl enable inside.service"

# A view of the control groups as systemd has them on Debian 12 (version 2 only), whatever this machine has.
boot() {
  local layer=$1 root=$2 group=$3
  mount -t overlay overlay -o "lowerdir=$root,upperdir=$layer/root/changes,workdir=$layer/root/work" "$layer/root/merged"
  umount -R /sys/fs/cgroup
  mount -t cgroup2 cgroup2 /sys/fs/cgroup
  mkdir "/sys/fs/cgroup/$group"
  echo $$ > "/sys/fs/cgroup/$group/cgroup.procs"
  # bpf: what filters addresses (IPAddressDeny=) and devices (DevicePolicy=).
  exec systemd-nspawn --quiet --directory "$layer/root/merged" --boot --private-network --keep-unit --register=no \
    --console=pipe --capability=CAP_BPF --system-call-filter=bpf --link-journal=no
}
export -f boot
status=0
unshare --mount --fork bash -euo pipefail -c 'boot "$@"' boot "$layer" "$root" "$group" \
  < /dev/null > "$layer/console" 2>&1 || status=$?
cat "$layer/root/changes/said" || { cat "$layer/console"; exit 1; }
exit "$status"
