// Where the tests find what is not in their own files.
import { existsSync } from "node:fs";
import { join } from "node:path";

const SOURCE = process.env.AMALGAM_SOURCE_DIR ?? process.cwd();

export const sourceFile = (path) => join(SOURCE, path);
export const buildFolder = () => process.env.AMALGAM_BINARY_DIR ?? join(SOURCE, "build");

/** @returns {string | null} data that is not part of the repository, as tests/support/test_data.h */
export function testData() {
  const folder = process.env.AMALGAM_TEST_DATA ?? join(SOURCE, "../shared/data");
  return existsSync(folder) ? folder : null;
}
