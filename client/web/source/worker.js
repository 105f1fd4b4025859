// Turns camera frames into what is sent: a JPEG and the corners of the markers in it. In a worker,
// so that the page stays quick.
import { Detector } from "./markers/detector.js";
import { GreyImage } from "./markers/grey_image.js";
import table from "./markers/opencv.json";

/** @type {{detector: Detector, grey: GreyImage, canvas: OffscreenCanvas, quality: number}} */
let setup = null;

function prepare({ dictionary, ids, width, height, quality }) {
  const canvas = new OffscreenCanvas(width, height);
  setup = {
    detector: new Detector(table, dictionary, width, height, ids),
    grey: new GreyImage(width, height),
    canvas,
    context: canvas.getContext("2d", { willReadFrequently: true, alpha: false }),
    quality,
  };
}

async function process({ frameId, bitmap }) {
  const { detector, grey, canvas, context, quality } = setup;
  const begin = performance.now();
  context.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
  bitmap.close();
  grey.setFromRgba(context.getImageData(0, 0, canvas.width, canvas.height).data);
  const drawn = performance.now();
  // The browser encodes on another thread meanwhile.
  const encoding = canvas.convertToBlob({ type: "image/jpeg", quality: quality / 100 });
  const markers = detector.detect(grey);
  const searched = performance.now();
  const jpeg = await (await encoding).arrayBuffer();
  const times = {
    read: drawn - begin,
    search: searched - drawn,
    encode: performance.now() - searched,
  };
  // The page shows this very picture beside its composite.
  const picture = canvas.transferToImageBitmap();
  const corners = markers.map(({ id, corners: points }) => ({
    marker: id,
    pixels: points.flatMap(({ x, y }) => [x, y]),
  }));
  self.postMessage({ kind: "frame", frameId, jpeg, corners, picture, times }, [jpeg, picture]);
}

// Frames share the canvas, so one is done before the next begins.
let last = Promise.resolve();
self.onmessage = ({ data }) => {
  last = last
    .then(() => (data.kind === "setup" ? prepare(data) : process(data)))
    .catch((error) => {
      self.postMessage({ kind: "failed", frameId: data.frameId, text: error.message });
    });
};
