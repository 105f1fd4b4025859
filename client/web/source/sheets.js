// Links to what the page's server makes to print: only where it can, and the user's paper first.

// Where letters are written on US paper [CLDR, territoryInfo, paperSize].
const LETTER = "BZ CA CL CO CR GT MX NI PA PH PR SV US VE".split(" ");
const NAMES = { a4: "A4", letter: "US Letter" };

/**
 * @param {string} language as navigator.language
 * @returns {("a4" | "letter")[]} both, the likelier one first
 */
export function papersFor(language) {
  let region;
  try {
    ({ region } = new Intl.Locale(language).maximize());
  } catch {
    region = "";
  }
  return LETTER.includes(region) ? ["letter", "a4"] : ["a4", "letter"];
}

function link(address, text) {
  const anchor = document.createElement("a");
  anchor.href = address;
  anchor.target = "_blank";
  anchor.textContent = text;
  return anchor;
}

/**
 * Fills the elements that show links to a sheet, and shows them.
 * @param {Iterable<HTMLElement>} elements each with an element of class "links"
 * @param {string} file as "marker-sheet.pdf"
 */
export function showSheets(elements, file) {
  const address = (paper) => `${file}?paper=${paper}`;
  const papers = papersFor(navigator.language);
  for (const element of elements) {
    const links = papers.map((paper) => link(address(paper), NAMES[paper]));
    element.querySelector(".links").replaceChildren(links[0], " or ", links[1]);
    element.hidden = false;
  }
}

/**
 * @returns {Promise<boolean>} whether the page's server has that sheet for its scene: its markers
 *   may not fit on paper
 */
export async function hasSheet(file) {
  try {
    const { ok } = await fetch(`${file}?paper=${papersFor(navigator.language)[0]}`, {
      method: "HEAD",
    });
    return ok;
  } catch {
    return false;
  }
}
