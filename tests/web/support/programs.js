// Amalgam's own programs, run by a test.
import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { buildFolder, sourceFile } from "./places.js";

const program = (name) => join(buildFolder(), "bin", name);

export class Server {
  #process;
  /** host:port for native clients, of the page, and of the status page. */
  address = "";
  web = "";
  admin = "";

  /** @returns {Promise<Server>} that listens, with ports of its own or those given */
  static async start(scene, { webPort = 0, adminPort = 0, options = [] } = {}) {
    const server = new Server();
    const places = [
      "--listen",
      "127.0.0.1:0",
      "--admin",
      `127.0.0.1:${adminPort}`,
      "--web",
      `127.0.0.1:${webPort}`,
    ];
    const all = ["--scene", scene, ...places, "--log-level", "warn", ...options];
    return server.#begin("amalgam-server", all);
  }

  /** @returns {Promise<Server>} whose renderer takes so many ms and changes nothing */
  static async startStub(costMs) {
    return new Server().#begin("amalgam-stub-server", ["--cost", String(costMs)]);
  }

  async #begin(name, options) {
    const server = this;
    server.#process = spawn(program(name), options, { stdio: ["ignore", "pipe", "inherit"] });
    for await (const line of createInterface({ input: server.#process.stdout })) {
      const [, address] = /listening on (\S+)/.exec(line) ?? [];
      if (!address) continue;
      server.address = address;
      server.web = / web (\S+)/.exec(line)[1];
      server.admin = / admin (\S+)/.exec(line)?.[1];
      return server;
    }
    throw new Error(`${name} ended before it listened`);
  }

  get webPort() {
    return portOf(this.web);
  }
  get adminPort() {
    return portOf(this.admin);
  }

  stop() {
    return end(this.#process, "SIGTERM");
  }
  /** It has no time to say anything. */
  kill() {
    return end(this.#process, "SIGKILL");
  }
}

const portOf = (address) => Number(address.split(":").at(-1));

async function end(child, signal) {
  if (child.exitCode !== null || child.signalCode !== null) return;
  child.kill(signal);
  await once(child, "exit");
}

/** Clients of amalgam-load, until they are stopped. */
export class Load {
  #process;

  constructor(address, options) {
    const all = ["--server", address, "--duration", "600", ...options];
    this.#process = spawn(program("amalgam-load"), all, { stdio: "ignore" });
  }

  stop() {
    return end(this.#process, "SIGTERM");
  }
}

/** Runs the native client until it ends, and returns its composites in the order of frames. */
export function nativeComposites(address, source, frames) {
  const folder = mkdtempSync(join(tmpdir(), "amalgam-native-"));
  const options = [
    "--server",
    address,
    "--lockstep",
    "--frames",
    String(frames),
    "--output",
    folder,
  ];
  const { status, stderr } = spawnSync(program("amalgam-client"), [...options, ...source]);
  if (status !== 0) throw new Error(`amalgam-client: ${stderr}`);
  const name = (i) => join(folder, `frame-${String(i + 1).padStart(6, "0")}.jpg`);
  const composites = Array.from({ length: frames }, (_, i) => readFileSync(name(i)));
  rmSync(folder, { recursive: true });
  return composites;
}

/** @returns {number} ms from capture to composite, the median, of a film's frames */
export function nativeLatency(address, film, rate) {
  const options = ["--server", address, "--video", film, "--rate", String(rate), "--json"];
  const { status, stdout, stderr } = spawnSync(program("amalgam-client"), options);
  if (status !== 0) throw new Error(`amalgam-client: ${stderr}`);
  return JSON.parse(stdout).latency_ms.median;
}

/**
 * Pictures of the synthetic desk as its camera takes them: what a server without objects sends.
 * more: further options of the client
 */
export async function deskPictures(folder, size, frames, more = []) {
  const scene = join(folder, "empty.gltf");
  const empty = {
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ extras: { amalgam: { world_marker: 40 } } }],
  };
  writeFileSync(scene, JSON.stringify(empty));
  const server = await Server.start(scene, { options: ["--renderer", "raytrace"] });
  try {
    return nativeComposites(server.address, ["--synthetic", "--size", size, ...more], frames);
  } finally {
    await server.stop();
  }
}

export const sceneFile = (name) => sourceFile(`deploy/scenes/${name}.gltf`);
