#!/usr/bin/env bash
# From nothing to composites: installs what is missing, builds, starts the server for each scene, runs a client against it over TCP,
# leaves the composites in out/demo and prints the times. FRAMES=N sets the length of the synthetic films (default 30).
# Where openssl is installed, server and client speak TLS and the client shows a token.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
frames=${FRAMES:-30}
out=out/demo

deploy/install.sh
BUILD_TARGETS="amalgam-server amalgam-client" deploy/build.sh
deploy/fetch_assets.sh
rm -rf "$out"
mkdir -p "$out"

serving=() asking=()
if command -v openssl > /dev/null; then
  deploy/make_test_certificate.sh "$out/tls"
  (umask 077; openssl rand -hex 16 > "$out/tls/token")
  serving=(--tls-certificate "$out/tls/server.crt" --tls-key "$out/tls/server.key" --token-file "$out/tls/token")
  asking=(--tls --ca "$out/tls/server.crt" --token-file "$out/tls/token")
fi

server=0
stop_server() {
  [ "$server" -ne 0 ] || return 0
  kill -TERM "$server" 2>/dev/null || true
  wait "$server"
  server=0
}
trap stop_server EXIT

# start_server SCENE: sets $address once the server listens.
start_server() {
  build/bin/amalgam-server --scene "$1" --listen 127.0.0.1:0 --admin 127.0.0.1:0 "${serving[@]}" \
    > "$out/server.txt" 2>> "$out/server.log" &
  server=$!
  for _ in $(seq 300); do
    address=$(sed -n 's/^listening on \([^ ]*\) .*/\1/p' "$out/server.txt")
    [ -z "$address" ] || return 0
    kill -0 "$server" 2>/dev/null || { echo "demo: the server did not start; see $out/server.log" >&2; exit 1; }
    sleep 0.1
  done
  echo "demo: the server did not listen within 30 s" >&2
  exit 1
}

photo=out/assets/singlemarkersoriginal.jpg
calibration=out/assets/tutorial_camera_params.yml
for scene in deploy/scenes/{complex,diffuse,mirror}.gltf deploy/scenes/generated/bunny-{glass,mirror}.gltf; do
  name=$(basename "$scene" .gltf)
  [ -s "$scene" ] || { echo "demo: $name left out, its model could not be fetched"; continue; }
  start_server "$scene"
  if [ -s "$photo" ]; then
    echo "== $name on a photograph"
    build/bin/amalgam-client --server "$address" "${asking[@]}" --images "$photo" --calibration "$calibration" \
      --frames 1 --lockstep --output "$out/$name-photograph"
  fi
  echo "== $name on a moving synthetic camera, $frames frames of 800x600"
  # The complex scene has a model of a real mirror, which then must be there to be seen.
  mirror=()
  [ "$name" != complex ] || mirror=(--synthetic-mirror)
  build/bin/amalgam-client --server "$address" "${asking[@]}" --synthetic "${mirror[@]}" --frames "$frames" --lockstep \
    --output "$out/$name-synthetic"
  stop_server
done
echo "composites are in $out:"
find "$out" -name 'frame-000001.jpg' | sort
