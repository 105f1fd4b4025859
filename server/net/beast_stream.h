// A protocol::Stream with the interface that Beast asks of streams, so that its WebSocket is
// compiled once for TCP and TLS.
#pragma once

#include <boost/asio/post.hpp>
#include <boost/beast/core/bind_handler.hpp>
#include <boost/beast/core/role.hpp>
#include <utility>

#include "protocol/stream.h"

namespace amalgam::net {

class BeastStream {
 public:
  using executor_type = boost::asio::ip::tcp::socket::executor_type;

  explicit BeastStream(protocol::Stream& stream) : stream_(stream) {}

  executor_type get_executor() noexcept { return stream_.socket().get_executor(); }

  template <typename Buffers, typename Handler>
  void async_read_some(const Buffers& buffers, Handler&& handler) {
    stream_.visit([&](auto& to) { to.async_read_some(buffers, std::forward<Handler>(handler)); });
  }
  template <typename Buffers, typename Handler>
  void async_write_some(const Buffers& buffers, Handler&& handler) {
    stream_.visit([&](auto& to) { to.async_write_some(buffers, std::forward<Handler>(handler)); });
  }

  // Beast has exchanged close frames. Whoever owns the stream decides how long to linger.
  template <typename Handler>
  friend void async_teardown(boost::beast::role_type, BeastStream& stream, Handler&& handler) {
    stream.stream_.finish_sending();
    boost::asio::post(stream.get_executor(),
                      boost::beast::bind_front_handler(std::forward<Handler>(handler),
                                                       boost::system::error_code()));
  }
  friend void beast_close_socket(BeastStream& stream) { stream.stream_.close(); }

 private:
  protocol::Stream& stream_;
};

}  // namespace amalgam::net
