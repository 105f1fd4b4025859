#include "net/web_pages.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

namespace amalgam::net {
namespace {

namespace fs = std::filesystem;

class WebFolder : public testing::Test {
 protected:
  WebFolder() : root_(fs::temp_directory_path() / ("amalgam-web-" + std::to_string(::getpid()))) {
    fs::create_directories(root_ / "page" / "workers");
    write("secret.js", "secret");
    write("page/index.html", "<p>");
    write("page/.hidden.js", "hidden");
    write("page/workers/markers.mjs", "export {}");
  }
  ~WebFolder() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(root_ / name) << text;
  }
  std::optional<WebPage> find(std::string_view path) const {
    return find_web_page({}, root_ / "page", path);
  }

  fs::path root_;
};

TEST_F(WebFolder, FilesAndTheirKinds) {
  const auto index = find("/"), worker = find("/workers/markers.mjs");
  ASSERT_TRUE(index && worker);
  EXPECT_EQ(index->bytes(), "<p>");
  EXPECT_EQ(index->content_type, "text/html; charset=utf-8");
  EXPECT_EQ(worker->bytes(), "export {}");
  EXPECT_EQ(worker->content_type, "text/javascript; charset=utf-8");
  const std::string before = index->tag;
  write("page/index.html", "<q>");
  EXPECT_NE(find("/")->tag, before);
}

TEST_F(WebFolder, NothingOutsideItHasAName) {
  ASSERT_TRUE(fs::exists(root_ / "page/workers/../../secret.js"));
  for (const std::string_view path :
       {"/../secret.js", "/workers/../../secret.js", "/%2e%2e/secret.js", "/..%2fsecret.js",
        "//secret.js", "/./index.html", "/workers/", "/workers", "/.hidden.js", "index.html", "",
        "*", "/workers//markers.mjs", "/..\\secret.js"}) {
    EXPECT_FALSE(find(path)) << path;
  }
  EXPECT_FALSE(find(std::string_view("/index.html\0.js", 15)));
  EXPECT_FALSE(find("/" + (root_ / "secret.js").string()));
  EXPECT_FALSE(find("/" + std::string(100'000, 'a')));
  std::string deep;
  for (int i = 0; i < 10'000; ++i) deep += "/a";
  EXPECT_FALSE(find(deep));
}

TEST_F(WebFolder, LinksAndOddFilesAreNotFollowed) {
  fs::create_symlink(root_ / "secret.js", root_ / "page/link.js");
  fs::create_directory_symlink(root_, root_ / "page/up");
  ASSERT_EQ(::mkfifo((root_ / "page/pipe.js").c_str(), 0600), 0);
  EXPECT_FALSE(find("/link.js"));
  EXPECT_FALSE(find("/up/secret.js"));
  EXPECT_FALSE(find("/pipe.js"));  // and nobody waits for its writer
}

TEST(WebPages, EmbeddedFilesAreFoundByTheirWholePath) {
  const std::array<web::WebFile, 2> files{
      {{"index.html", "text/html", "page", "\"1\""},
       {"app.js", "text/javascript", std::string_view("a\0b", 3), "\"2\""}}};
  EXPECT_EQ(find_web_page(files, "", "/")->bytes(), "page");
  EXPECT_EQ(find_web_page(files, "", "/app.js")->bytes(), std::string_view("a\0b", 3));
  EXPECT_FALSE(find_web_page(files, "", "/app"));
  EXPECT_FALSE(find_web_page(files, "", "app.js"));
  EXPECT_EQ(find_web_page(files, "", "/")->tag, "\"1\"");
  EXPECT_EQ(find_web_page(files, "", "/app.js")->tag, "\"2\"");
}

}  // namespace
}  // namespace amalgam::net
