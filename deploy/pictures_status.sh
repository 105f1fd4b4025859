# Part of pictures.sh: the status page of a server with two sessions, by Chromium. After pictures_clients.sh.

chromium=${AMALGAM_CHROMIUM:-/usr/bin/chromium}
if ! command -v node >/dev/null || [ ! -x "$chromium" ] || [ ! -d build/web-packages/node_modules ]; then
  echo "pictures: no node, Chromium or build/web-packages; the status page's picture stays as it is" >&2
else
  "$bin/amalgam-server" --scene deploy/scenes/complex.gltf --listen 127.0.0.1:0 --admin 127.0.0.1:0 --admin-pictures \
    --max-load 0 --log-level warn > "$work/server.txt" &
  server=$!
  clients=()
  trap 'kill -TERM "${clients[@]}" $server 2>/dev/null || true' EXIT
  until grep -q listening "$work/server.txt"; do kill -0 "$server" || exit 1; sleep 0.1; done
  address=$(sed -n 's/^listening on \([^ ]*\) .*/\1/p' "$work/server.txt")
  for camera in "--size 480x360 --rate 3 --synthetic-mirror" "--size 320x240 --rate 6"; do
    # shellcheck disable=SC2086
    "$bin/amalgam-client" --server "$address" --synthetic $camera --output "$work/session-${#clients[@]}" > /dev/null &
    clients+=($!)
  done
  node deploy/pictures_status.mjs "$chromium" \
    "http://$(sed -n 's/.* admin \([^ ]*\).*/\1/p' "$work/server.txt")/" "$work/status.png"
  kill -TERM "${clients[@]}" "$server"
  wait "${clients[@]}" "$server" || true
  trap - EXIT
  convert "$work/status.png" -strip -quality 80 "$out/status.webp"
fi
