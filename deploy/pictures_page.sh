# Part of pictures.sh: the page for browsers, as a film and as a picture. Needs Chromium and a build with the page.
if [ -e build/web-packages/tests/tools/film.mjs ] && command -v "${AMALGAM_CHROMIUM:-chromium}" >/dev/null; then
  rm -rf "$work/page"
  AMALGAM_BINARY_DIR=$(dirname "$(realpath "$bin")") node build/web-packages/tests/tools/film.mjs "$work/page"
  convert -delay 8 -loop 0 "$work"/page/film-*.png -resize 720x -strip -quality 55 -define webp:method=6 "$out/page-film.webp"
  convert "$work/page/page.png" -strip -quality 80 "$out/page.webp"
else
  echo "pictures: without Chromium, or without the page, its pictures stay as they are" >&2
fi
