// A client that connects and says nothing, not even hello, and hears what the server thinks of
// that. The one client of the load without a Link, which always says hello.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "client/tools/load/load_options.h"
#include "client/tools/load/load_summary.h"
#include "protocol/framing.h"
#include "protocol/stream.h"

namespace amalgam::load {

class SilentClient : public std::enable_shared_from_this<SilentClient> {
 public:
  // All outlive it.
  SilentClient(boost::asio::io_context& io, const LoadOptions& options, LoadSummary& summary);
  void start(const std::optional<boost::asio::ip::address>& source);

 private:
  using ErrorCode = boost::system::error_code;
  void read();
  void take(std::size_t size);
  void end(bool lost);

  const LoadOptions& options_;
  LoadSummary& summary_;
  protocol::Stream stream_;
  boost::asio::steady_timer timer_;
  bool ended_ = false;
  protocol::Decoder decoder_{protocol::limits_of_client()};
  std::vector<std::byte> buffer_;
};

}  // namespace amalgam::load
