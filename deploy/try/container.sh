#!/usr/bin/env bash
# container.sh [ROOT]: builds the image as Containerfile says and runs it as its head says: without rights, on a file
# system that cannot be written, healthy, with a token file that nobody else reads, and ending by itself. Needs podman.
# ROOT: a bare Debian (bare.sh) that stands for debian:12-slim where no registry can be reached.
#   BUILD_OPTIONS, RUN_OPTIONS    more options for podman, as --network=host
#   BUILD=no                      the image is there already
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
read -ra build_options <<< "${BUILD_OPTIONS:-}"
read -ra run_options <<< "${RUN_OPTIONS:-}"
say() { echo "== $*"; }
fail() { echo "container: $*" >&2; exit 1; }
if [ $# -gt 0 ]; then
  tar -C "$1" --one-file-system -c . | podman import - docker.io/library/debian:12-slim
  build_options+=(--pull=never)
fi

if [ "${BUILD:-yes}" = yes ]; then
  say "build"
  podman build "${build_options[@]}" --format docker -f deploy/container/Containerfile -t amalgam .
fi
podman image inspect --format 'image: {{.Size}} bytes, user {{.User}}' amalgam

say "run"
name=amalgam-try-$$
work=$(mktemp -d)
end() { podman rm -f -t 0 "$name" > /dev/null 2>&1 || true; rm -rf "$work"; }
trap end EXIT
(umask 077; head -c 16 /dev/urandom | od -An -tx1 | tr -d ' \n' > "$work/tokens")
podman run -d --name "$name" "${run_options[@]}" --read-only --cap-drop=all --security-opt=no-new-privileges \
  --stop-timeout=35 -p 7447:7447 -v "$work/tokens:/etc/amalgam/tokens:ro,U" amalgam \
  --token-file /etc/amalgam/tokens > /dev/null
# It is alive while it loads, which takes a busy machine a minute, and ready afterwards.
ready='exec 3<>/dev/tcp/127.0.0.1/7448 && printf "GET /readyz HTTP/1.0\r\n\r\n" >&3 && head -1 <&3 | grep -q " 200 "'
for _ in $(seq 180); do
  ! podman exec "$name" timeout 2 bash -c "$ready" 2> /dev/null || break
  [ "$(podman inspect --format '{{.State.Running}}' "$name")" = true ] || { podman logs "$name"; fail "it ended"; }
  sleep 1
done
podman healthcheck run "$name" || { podman logs "$name"; fail "it is not healthy"; }
[ "$(podman exec "$name" id -u)" = 65532 ] || fail "not as user 65532"
podman exec "$name" grep -q '^CapEff:.0*$' /proc/1/status || fail "it has capabilities"
podman exec "$name" grep -q '^NoNewPrivs:.1$' /proc/1/status || fail "it may get new rights"
for folder in / /etc /usr/share/amalgam /etc/amalgam; do
  ! podman exec "$name" touch "$folder/written" 2> /dev/null || fail "$folder can be written"
done

say "composites by the image's own client"
inside() {
  podman run --rm --network "container:$name" -v "$work/tokens:/etc/amalgam/tokens:ro" --entrypoint "$1" amalgam "${@:2}"
}
inside amalgam-client --token-file /etc/amalgam/tokens --synthetic --frames 10 --lockstep
! inside amalgam-client --synthetic --frames 1 --connect-timeout 2 2> /dev/null || fail "it serves without a token"

say "a server that stands still is not healthy"
podman kill --signal STOP "$name" > /dev/null
! podman healthcheck run "$name" > /dev/null 2>&1 || fail "it is healthy though it stands still"
podman kill --signal CONT "$name" > /dev/null
podman healthcheck run "$name" || fail "it is not healthy again"

say "stop"
start=$SECONDS
podman stop "$name" > /dev/null
code=$(podman inspect --format '{{.State.ExitCode}}' "$name")
[ "$code" = 0 ] || fail "it ended with $code"
echo "ended after $((SECONDS - start)) s, of which 5 for load balancers (--drain-delay)"
podman logs "$name" 2>&1 | tail -n 5
say "the image works"
