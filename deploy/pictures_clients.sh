# Part of pictures.sh: by way of server and client.

# serve SCENE CLIENT'S OPTIONS...: one client's session, its composites in $work/session.
serve() {
  local address=
  rm -rf "$work/session"
  "$bin/amalgam-server" --scene "$1" --samples "${samples:-9}" --listen 127.0.0.1:0 --admin 127.0.0.1:0 --log-level warn > "$work/server.txt" &
  server=$!
  trap 'kill -TERM $server 2>/dev/null || true' EXIT
  until grep -q listening "$work/server.txt"; do kill -0 "$server" || return 1; sleep 0.1; done
  address=$(sed -n 's/^listening on \([^ ]*\) .*/\1/p' "$work/server.txt")
  "$bin/amalgam-client" --server "$address" --lockstep --quality 90 --output "$work/session" "${@:2}" > /dev/null
  kill -TERM "$server"
  wait "$server"
  trap - EXIT
}

# One pose from all the markers of a board; the world's origin is in its middle.
board=$data/real_markers/opencv_contrib
if have real_markers/opencv_contrib/choriginal.jpg; then
  serve deploy/scenes/glassware.gltf --images "$board/choriginal.jpg" --calibration "$board/tutorial_camera_charuco.yml" \
    --charuco 5x7:0.06:0.03 --frames 1
  jpeg "$work/session/frame-000001.jpg" board -crop 480x360+110+10
fi
