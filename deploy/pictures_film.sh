# Part of pictures.sh: the demo as a film. After pictures_clients.sh, which has serve().

# The whole way of the synthetic camera, after which it begins again. Every fourth frame is shown, about twelve a second.
samples=adaptive serve deploy/scenes/complex.gltf --synthetic --synthetic-mirror --size 480x360 --frames 240
shown=()
for frame in $(seq 1 4 240); do
  shown+=("$work/session/frame-$(printf %06d "$frame").jpg")
done
convert -delay 8 -loop 0 "${shown[@]}" -strip -quality 60 -define webp:method=6 "$out/complex-synthetic.webp"
