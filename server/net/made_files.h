// Files of the web port that are made when somebody first asks for them (WebOptions::made): on a
// thread of their own, so that nobody else waits, once for each scene, and kept. The first sheet of
// markers takes tens of milliseconds, in which fonts are looked for. On the network thread.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/thread_pool.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "net/server_config.h"
#include "net/web_pages.h"

namespace amalgam::net {

class MadeFiles {
 public:
  struct Missing {
    std::string why;  // a line for people
  };
  using Result = std::variant<WebPage, Missing>;
  // Must not throw.
  using Done = std::function<void(const Result&)>;
  using Markers = std::function<frame::FrameService::MarkerSet()>;

  // io: of the network thread. markers: the scene's, at the moment of the call.
  MadeFiles(boost::asio::io_context& io, Markers markers);
  ~MadeFiles();

  // target: as asked for; make: of WebOptions::made. done is called at once, or when the file is
  // there; those who ask meanwhile wait for the same one.
  void get(const std::string& target, const MakeFile& make, Done done);

  // The scene has changed: what was made is of the last one.
  void forget();

 private:
  struct Entry {
    std::optional<Result> result;
    std::vector<Done> waiting;
  };
  using Key = std::pair<std::uint64_t, std::string>;  // the scene's number, the target
  void finish(const Key& key, Result result);

  boost::asio::io_context& io_;
  Markers markers_;
  std::uint64_t scene_ = 0;
  std::map<Key, Entry> entries_;
  std::optional<boost::asio::thread_pool> thread_;  // from the first request on
};

}  // namespace amalgam::net
