// Elements made in one line. Text never becomes HTML: some of it comes from whoever connects.

/**
 * @param {string} tag
 * @param {Record<string, string>} attributes `text` becomes the element's text
 * @param {...Node} children
 */
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === "text") element.textContent = value;
    else element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

/** Changes what is there only if it differs, so that selected text stays selected. */
export function say(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

export const byId = (id) => document.getElementById(id);
