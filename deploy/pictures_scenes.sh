# Part of pictures.sh: scenes and materials.
for scene in complex diffuse; do
  render --scene "deploy/scenes/$scene.gltf" "${photo[@]}" --samples 9 --output "$out/$scene-photograph.jpg"
done
for bunny in bunny-glass bunny-mirror; do
  render --scene "deploy/scenes/generated/$bunny.gltf" "${photo[@]}" --samples 9 --output "$out/$bunny-photograph.jpg"
done

render --scene deploy/scenes/glassware.gltf "${large[@]}" --shadow-edges traced --output "$work/glassware.png"
jpeg "$work/glassware.png" glassware -crop 640x480+460+220

render --scene deploy/scenes/markers.gltf "${large[@]}" --output "$work/markers.png"
jpeg "$work/markers.png" markers -crop 800x600+250+220 -resize 640x480

if have gltf/transmission_chalice; then
  rm -rf "$work/chalice"
  python3 -B deploy/scenes/wrap_gltf.py "$data/gltf/transmission_chalice/KHR_materials_transmission.gltf" \
    --upside-down --output "$work/chalice/chalice.gltf"
  render --scene "$work/chalice/chalice.gltf" "${large[@]}" --output "$work/chalice.png"
  jpeg "$work/chalice.png" chalice -crop 640x480+460+220
fi

# One scene by the light of two maps.
if have envmaps/pmndrs/hall.exr envmaps/pmndrs/bridge.exr; then
  for map in hall bridge; do
    mkdir -p "$work/$map"
    cp deploy/scenes/mirror.gltf deploy/scenes/mirror.bin "$work/$map"
    cat "$data/envmaps/pmndrs/$map.exr" > "$work/$map/environment.exr"
    render --scene "$work/$map/mirror.gltf" "${large[@]}" --output "$work/$map.png"
    jpeg "$work/$map.png" "environment-$map" -crop 640x480+480+220
  done
fi
