#include "web/web_files.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace amalgam::web {
namespace {

// The files of the folder page, whose table stands in for the server's own.
TEST(WebFiles, TheBuildEmbedsEveryByte) {
  const auto files = web_files();
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[0].path, "empty.css");
  EXPECT_EQ(files[0].content_type, "text/css; charset=utf-8");
  EXPECT_EQ(files[0].bytes, "");
  EXPECT_EQ(files[0].tag, "\"e3b0c44298fc1c149afbf4c8996fb924\"");  // SHA-256 of nothing, begun
  EXPECT_EQ(files[1].path, "index.html");
  EXPECT_EQ(files[1].bytes, "<!doctype html>\n<p>\"quoted\" \\ )glsl\"\n");
  EXPECT_NE(files[1].tag, files[2].tag);
  EXPECT_EQ(files[2].path, "workers/tiny.wasm");
  EXPECT_EQ(files[2].content_type, "application/wasm");
  EXPECT_EQ(files[2].bytes, std::string_view("\0asm\1\0\0\0", 8));
}

}  // namespace
}  // namespace amalgam::web
