// Films for a browser's camera, as Y4M: grey pictures, repeated for as long as somebody looks.
import { writeFileSync } from "node:fs";

/**
 * @param {string} file
 * @param {GreyImage[]} pictures of one size, of even width and height
 */
export function writeFilm(file, pictures) {
  const { width, height } = pictures[0];
  const grey = Buffer.alloc((width * height) / 2, 128); // both color planes
  const parts = [Buffer.from(`YUV4MPEG2 W${width} H${height} F30:1 Ip A1:1 C420jpeg\n`)];
  for (const { data } of pictures) parts.push(Buffer.from("FRAME\n"), Buffer.from(data), grey);
  writeFileSync(file, Buffer.concat(parts));
}
