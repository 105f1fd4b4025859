# Part of pictures.sh: what options of the renderer change, seen from near.
beside() { convert "${@:2}" -bordercolor white -border 2x0 +append "$1"; }

# Adaptive samples: 1, adaptive, 9, and where adaptive took nine of them.
for samples in 1 adaptive 9; do
  render --scene deploy/scenes/complex.gltf "${photo[@]}" --samples "$samples" --output "$work/samples-$samples.png"
  convert "$work/samples-$samples.png" -crop 110x110+270+175 +repage -filter point -resize 400% "$work/near-$samples.png"
done
convert "$work/samples-1.png" "$work/samples-adaptive.png" -compose difference -composite -colorspace gray \
  -threshold 0 -crop 110x110+270+175 +repage -filter point -resize 400% "$work/near-refined.png"
beside "$work/adaptive.png" "$work"/near-{1,adaptive,refined,9}.png
jpeg "$work/adaptive.png" adaptive -resize 1280x

# Shadow edges, of a straw and of glass in glass: as exact as the shadow map, or traced.
for edges in map traced; do
  render --scene deploy/scenes/glassware.gltf "${large[@]}" --shadow-edges "$edges" --output "$work/edges-$edges.png"
  for place in 120x80+700+520 120x80+930+440; do
    convert "$work/edges-$edges.png" -crop "$place" +repage -filter point -resize 400% miff:-
  done | convert - -append "$work/near-$edges.png"
done
beside "$work/edges.png" "$work"/near-{map,traced}.png
jpeg "$work/edges.png" shadow-edges

# Where each pixel's light comes from.
render --scene deploy/scenes/complex.gltf "${photo[@]}" --samples 9 --dump "$work/dump"
jpeg "$work/dump/provenance.png" provenance
