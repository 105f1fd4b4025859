#include "net/made_files.h"

#include <boost/asio/post.hpp>
#include <exception>
#include <string_view>

#include "net/quietly.h"

namespace amalgam::net {
namespace {

std::string_view path_of(std::string_view target) {
  return target.substr(0, target.find('?'));
}

MadeFiles::Result make_now(const std::string& target, const MakeFile& make,
                           const frame::FrameService::MarkerSet& markers) {
  try {
    return made_page(path_of(target), make(markers));
  } catch (const std::exception& error) {
    return MadeFiles::Missing{error.what()};
  }
}

}  // namespace

MadeFiles::MadeFiles(boost::asio::io_context& io, Markers markers)
    : io_(io), markers_(std::move(markers)) {}

MadeFiles::~MadeFiles() {
  if (thread_) thread_->join();
}

void MadeFiles::get(const std::string& target, const MakeFile& make, Done done) {
  const Key key(scene_, target);
  Entry& entry = entries_[key];
  if (entry.result) return done(*entry.result);
  entry.waiting.push_back(std::move(done));
  if (entry.waiting.size() > 1) return;  // it is being made
  try {
    if (!thread_) thread_.emplace(1);
    boost::asio::post(*thread_, [this, key, make, markers = markers_()] {
      Result result = make_now(key.second, make, markers);
      quietly([&] {
        boost::asio::post(
            io_, [this, key, made = std::move(result)]() mutable { finish(key, std::move(made)); });
      });
    });
  } catch (const std::exception&) {
    entry.waiting.clear();  // so that the next one tries again
    throw;
  }
}

void MadeFiles::finish(const Key& key, Result result) {
  const auto entry = entries_.find(key);
  const std::vector<Done> waiting = std::exchange(entry->second.waiting, {});
  if (key.first != scene_) {
    entries_.erase(entry);
  } else {
    entry->second.result = result;
  }
  for (const Done& done : waiting) done(result);
}

void MadeFiles::forget() {
  ++scene_;
  std::erase_if(entries_, [](const auto& entry) { return entry.second.result.has_value(); });
}

}  // namespace amalgam::net
