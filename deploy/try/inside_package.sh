#!/usr/bin/env bash
# inside_package.sh DEB: the part of debian_package.sh that runs on the bare machine.
set -euo pipefail
deb=${1:?usage: inside_package.sh DEB}
export DEBIAN_FRONTEND=noninteractive DEBCONF_NOWARNINGS=yes
say() { echo "== $*"; }
fail() { echo "package: $*" >&2; exit 1; }

# http PATH: the status that the admin port answers with. A bare machine has no curl.
http() {
  local version status=000 rest
  { exec 3<>/dev/tcp/127.0.0.1/7448; } 2>/dev/null || { echo 000; return; }
  printf 'GET %s HTTP/1.0\r\n\r\n' "$1" >&3
  read -r version status rest <&3 || true
  exec 3>&-
  echo "$status"
}

mkdir /composites
mount -t tmpfs -o mode=1777 tmpfs /composites

say "install"
apt-get update -qq
apt-get install -y -qq --no-install-recommends "$deb" > /dev/null
dpkg --verify amalgam
[ "$(stat -c '%U:%G %a' /etc/amalgam)" = "root:amalgam 750" ] || fail "/etc/amalgam is open"
dpkg-query -W -f='amalgam ${Version}, ${Installed-Size} KiB; ' amalgam
echo "$(dpkg-query -W -f='.\n' | wc -l) packages, $(du -shx / --exclude=/proc --exclude=/sys --exclude=/dev | cut -f 1)"

say "man pages"
apt-get install -y -qq --no-install-recommends man-db > /dev/null
for program in server client render inspect load marker; do
  amalgam-$program --version > /dev/null
  man --warnings -P cat "amalgam-$program" 2> /composites/warnings | grep -q -- --help || fail "no man page of amalgam-$program"
  [ ! -s /composites/warnings ] || fail "man page of amalgam-$program: $(cat /composites/warnings)"
done

say "server, as user amalgam, on a file system that cannot be written"
# as USER COMMAND...: without capabilities, and without the way to any.
as() { setpriv --reuid "$1" --regid "$(id -g "$1")" --clear-groups --no-new-privs --bounding-set=-all "${@:2}"; }
export -f as
unshare --mount bash -euo pipefail -c 'mount --bind / / && mount -o remount,bind,ro / && cd / &&
  ! touch /root/x 2>/dev/null &&
  as amalgam env HOME=/nonexistent MESA_SHADER_CACHE_DISABLE=true amalgam-server --config /etc/amalgam/server.toml' \
  > /composites/server.txt 2> /composites/server.log &
server=$!
for _ in $(seq 300); do
  [ "$(http /readyz)" != 200 ] || break
  kill -0 $server || { cat /composites/server.log; fail "the server did not start"; }
  sleep 0.1
done
[ "$(http /livez) $(http /readyz)" = "200 200" ] || fail "livez $(http /livez), readyz $(http /readyz)"
pid=$(sed -n 's/^Pid:\t//p' $(grep -l '^Name:.amalgam-server$' /proc/[0-9]*/status))
[ "$(stat -c %U "/proc/$pid")" = amalgam ] || fail "the server is not amalgam's"
grep -q '^CapEff:.0*$' "/proc/$pid/status" || fail "the server has capabilities"

say "client and load, as nobody"
as nobody amalgam-client --synthetic --frames 10 --lockstep --output /composites/client
[ "$(find /composites/client -name 'frame-*.jpg' -size +1k | wc -l)" -eq 10 ] || fail "not 10 composites"
as nobody amalgam-load --frames 10 --rate 5
[ "$(http /livez) $(http /readyz)" = "200 200" ] || fail "not well after work"

say "it ends"
kill -TERM "$pid"
wait $server || fail "the server ended with $?"
cat /composites/server.log
! grep -E ' (error|warning|warn) ' /composites/server.log || fail "the log complains"

say "purge"
apt-get purge -y -qq amalgam > /dev/null
left=$(find / -xdev -path /amalgam -prune -o -iname '*amalgam*' -print | grep -vE '^/(composites|var/cache/man)/' || true)
[ -z "$left" ] || fail "left behind: $left"
say "the package works on a bare Debian"
