// What the page says about its state, in plain words. A notice is
//   {level: "info" | "warn" | "error", title, text, action, prints}
// action: "retry", "start", "settings" or none. prints: whether links to printed markers help.

const CAMERA = {
  insecure: {
    title: "The camera needs HTTPS",
    text:
      "Browsers give cameras only to pages that came by HTTPS or from this machine itself. Open " +
      "this page with https://, or reach the server through localhost.",
  },
  denied: {
    title: "The camera is not allowed",
    text:
      "Allow it by the camera or lock symbol beside the page's address, or in the system's " +
      "privacy settings. Then start it again.",
  },
  none: {
    title: "No camera was found",
    text: "Connect one, and start it again.",
  },
  busy: {
    title: "The camera cannot be read",
    text: "Another program may be using it. Close that, and start the camera again.",
  },
  failed: {
    title: "The camera does not start",
    text: "The browser gives this reason:",
  },
  ended: {
    title: "The camera has ended",
    text: "It was unplugged or taken away. Connect it, and start it again.",
  },
};

const REFUSED = {
  AUTH_FAILED: {
    title: "The token is wrong",
    text: "This server asks for a token. Type it in the settings, exactly as it was given to you.",
  },
  UNSUPPORTED_VERSION: {
    title: "Server and page do not fit together",
    text: "They speak different versions of the protocol. Load this page from the server itself.",
  },
  BAD_HELLO: {
    title: "The server cannot use this camera",
    text: "Choose another size, field of view or calibration.",
  },
};

/** @param {string} reason of a CameraError */
export function cameraNotice(reason, detail = "") {
  const { title, text } = CAMERA[reason] ?? CAMERA.failed;
  const whole = reason === "failed" && detail ? `${text} ${detail}` : text;
  const action = reason === "insecure" ? undefined : "start";
  return { level: "error", title, text: whole, action };
}

/** @returns {object | null} of a Session's status; null if there is nothing to say */
export function sessionNotice(status) {
  switch (status.kind) {
    case "connecting":
      return { level: "info", title: "Connecting", text: "Waiting for the server." };
    case "draining":
      return {
        level: "warn",
        title: "The server is about to end",
        text: "Afterwards this page connects again by itself.",
      };
    case "busy":
      return {
        level: "warn",
        title: "The server is full",
        text: `It says: ${status.reason}.`,
        action: "retry",
      };
    case "lost":
      return {
        level: "warn",
        title: "The connection is lost",
        text: `${capital(status.reason)}.`,
        action: "retry",
      };
    case "refused": {
      const words = REFUSED[status.code] ?? { title: "The server refuses", text: "" };
      const detail = status.text ? ` The server says: ${status.text}.` : "";
      return { level: "error", title: words.title, text: words.text + detail, action: "settings" };
    }
    default:
      return null;
  }
}

/** @returns {string} what the page says while it waits, or nothing */
export function countDown(retryAt, now) {
  if (retryAt === undefined) return "";
  const seconds = Math.ceil((retryAt - now) / 1000);
  return seconds > 0 ? `Trying again in ${seconds} s.` : "Trying again now.";
}

/** @param {{dictionary: string, length: number, ids: number[], worldMarker: number}} markers */
export function noMarkerNotice({ dictionary, ids, length }) {
  const some = ids.slice(0, 5).join(", ") + (ids.length > 5 ? ", …" : "");
  const words = ids.length > 1 ? `one of the markers ${some}` : `marker ${some}`;
  return {
    level: "info",
    title: "No marker in view",
    text:
      `Point the camera at ${words} (${dictionary}, ${(length * 1000).toFixed(0)} mm wide). ` +
      "It must lie flat, with its white margin, and without glare.",
    prints: true,
  };
}

/** Short, for the chip in the page's head. */
export function chip(status) {
  const words = {
    connecting: "connecting",
    ready: "connected",
    draining: "server is ending",
    busy: "server is full",
    lost: "not connected",
    refused: "refused",
    closed: "not connected",
  };
  return words[status.kind];
}

function capital(text) {
  return text.charAt(0).toUpperCase() + text.slice(1).replace(/\.$/, "");
}
