// The messages of protocol/amalgam.proto as bytes and back. Over a WebSocket each binary message is
// one Envelope, without the length that goes before it over TCP.
//
// A message here is {case: "cameraFrame", value: {...}}: the Envelope's one body. Fields have the
// names of amalgam.proto in camel case; uint64 are BigInt, bytes are Uint8Array.
import { create, createFileRegistry, fromBinary, toBinary } from "@bufbuild/protobuf";
import { FileDescriptorSetSchema } from "@bufbuild/protobuf/wkt";
import descriptorSet from "amalgam.binpb";

export const PROTOCOL_VERSION = 1;

// PROTOCOL.md, Limits: what a client checks before it parses.
export const MAX_COMPOSITE_BYTES = 32 * 1024 * 1024;

const registry = createFileRegistry(fromBinary(FileDescriptorSetSchema, descriptorSet));
const envelopeSchema = registry.getMessage("amalgam.protocol.Envelope");
const errorCodes = registry.getEnum("amalgam.protocol.Error.Code");

/**
 * @param {string} kind the body's name, as "hello"
 * @param {object} value its fields
 * @returns {Uint8Array}
 */
export function encode(kind, value) {
  return toBinary(envelopeSchema, create(envelopeSchema, { body: { case: kind, value } }));
}

/**
 * @param {ArrayBuffer | Uint8Array} bytes
 * @returns {{case: string, value: object}} throws if it is no Envelope with a body
 */
export function decode(bytes) {
  const array = bytes instanceof Uint8Array ? bytes : new Uint8Array(bytes);
  if (array.length > MAX_COMPOSITE_BYTES) throw new Error("the server's message is too long");
  const { body } = fromBinary(envelopeSchema, array);
  if (!body.case) throw new Error("the server sent a message without a body");
  return body;
}

/** @returns {string} "AUTH_FAILED" for 5, and "ERROR_99" for a code that this page does not know */
export function errorName(code) {
  return errorCodes.values.find((value) => value.number === code)?.name ?? `ERROR_${code}`;
}
