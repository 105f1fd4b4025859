// OpenCV's XML as the same objects that its YAML gives.

const isMatrix = (element) => /matrix$/.test(element.getAttribute("type_id") ?? "");

function valueOf(element) {
  const children = [...element.children];
  if (children.length === 0) return element.textContent.trim();
  return Object.fromEntries(
    children.map((child) => {
      const isData = child.nodeName === "data" && isMatrix(element);
      return [child.nodeName, isData ? child.textContent.trim().split(/\s+/) : valueOf(child)];
    }),
  );
}

/** @returns {object} throws an Error in plain words */
export function parseXml(text) {
  const file = new DOMParser().parseFromString(text, "text/xml");
  // Browsers put what is wrong into the document.
  if (file.querySelector("parsererror")) throw new Error("the XML is damaged");
  const root = file.documentElement;
  if (root.nodeName !== "opencv_storage") throw new Error("it is XML, but not OpenCV's");
  return valueOf(root);
}
