// Draws the composite and, left of the slider's line, the camera's picture of the same frame. The
// canvas has the camera's size; the style sheet scales it to the window.

/** @returns {SVGElement} */
function svg(name, attributes) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}

export class CompositeView {
  #canvas;
  #outlines;
  #line;
  #context;
  #frame = null; // {composite, picture} as bitmaps
  #share = 0;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {SVGSVGElement} outlines lies over the canvas; what is drawn there is in no film
   * @param {HTMLElement} line between camera and composite
   */
  constructor(canvas, outlines, line) {
    this.#canvas = canvas;
    this.#outlines = outlines;
    this.#line = line;
    this.#context = canvas.getContext("2d", { alpha: false });
  }

  get canvas() {
    return this.#canvas;
  }

  /** @param {number} share of the width that shows the camera, 0 to 1, from the left */
  setCameraShare(share) {
    this.#share = share;
    this.#line.style.setProperty("--share", share);
    this.#line.hidden = share <= 0 || share >= 1;
    if (this.#frame) this.#draw();
  }

  /** Shows the camera alone, while there are no composites. */
  showVideo(video) {
    this.#take(null);
    this.#resize(video.videoWidth, video.videoHeight);
    this.#context.drawImage(video, 0, 0);
    this.outline([]);
  }

  /** @param {{composite: ImageBitmap, picture: ImageBitmap}} frame from now on the view's own */
  show(frame) {
    this.#take(frame);
    this.#resize(frame.picture.width, frame.picture.height);
    this.#draw();
  }

  /** @param {{marker: number, pixels: number[]}[]} corners of the markers to outline */
  outline(corners) {
    this.#outlines.replaceChildren(
      ...corners.flatMap(({ marker, pixels }) => {
        // Pixel (0, 0) is a pixel's centre for markers, and its corner for SVG.
        const at = pixels.map((value) => value + 0.5);
        const points = [0, 2, 4, 6].map((i) => `${at[i]},${at[i + 1]}`).join(" ");
        const label = svg("text", { x: at[0], y: at[1] });
        label.textContent = marker;
        return [svg("polygon", { points }), svg("circle", { cx: at[0], cy: at[1], r: 3 }), label];
      }),
    );
  }

  #take(frame) {
    if (this.#frame) {
      this.#frame.picture.close();
      if (this.#frame.composite !== this.#frame.picture) this.#frame.composite.close();
    }
    this.#frame = frame;
  }

  #resize(width, height) {
    if (this.#canvas.width === width && this.#canvas.height === height) return;
    this.#canvas.width = width;
    this.#canvas.height = height;
    this.#outlines.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.#canvas.parentElement.style.setProperty("--aspect", width / height);
  }

  #draw() {
    const { composite, picture } = this.#frame;
    const { height } = this.#canvas;
    this.#context.drawImage(composite, 0, 0);
    const width = Math.round(this.#share * this.#canvas.width);
    if (width > 0) this.#context.drawImage(picture, 0, 0, width, height, 0, 0, width, height);
  }
}
