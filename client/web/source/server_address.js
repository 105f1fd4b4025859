// The address of the server's sessions, from what was typed and from the page's own address.

const SESSION_PATH = "/session";

/**
 * @param {string} typed "", "host:port", or a whole ws://, wss://, http:// or https:// address
 * @param {{protocol: string, host: string}} page the page's location
 * @returns {string} a ws:// or wss:// address; throws an Error in plain words
 */
export function sessionAddress(typed, page) {
  const secure = page.protocol === "https:";
  const text = typed.trim() || page.host;
  const whole = /^[a-z]+:\/\//i.test(text) ? text : `${secure ? "wss" : "ws"}://${text}`;
  let url;
  try {
    url = new URL(whole.replace(/^http/i, "ws"));
  } catch {
    throw new Error(`“${text}” is not an address. Type it as host:port.`);
  }
  if (!["ws:", "wss:"].includes(url.protocol)) {
    throw new Error(`“${text}” is not an address that a page can connect to.`);
  }
  if (secure && url.protocol === "ws:") {
    throw new Error("This page came by HTTPS, so the server must be reached by wss:// too.");
  }
  if (url.pathname === "/") url.pathname = SESSION_PATH;
  return url.href;
}
