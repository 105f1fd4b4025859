#include "net/admin.h"

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "common/log.h"
#include "net/quietly.h"
#include "protocol/limits.h"

namespace amalgam::net {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using boost::asio::ip::tcp;
using boost::system::error_code;

constexpr std::uint32_t kMaxHeaderBytes = 8 * 1024;  // browsers stay below
constexpr std::uint64_t kMaxBodyBytes = 1024;        // no page takes one

}  // namespace

class Admin::Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(tcp::socket socket, std::shared_ptr<Shared> shared)
      : stream_(std::move(socket)), shared_(std::move(shared)) {
    place_ = shared_->connections.insert(shared_->connections.end(), this);
  }
  ~Connection() { leave(); }

  void close() {
    leave();
    error_code ignored;
    stream_.socket().close(ignored);
  }

  void read() {
    parser_.emplace();
    parser_->header_limit(kMaxHeaderBytes);
    parser_->body_limit(kMaxBodyBytes);
    stream_.expires_after(protocol::kAdminTimeout);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](const error_code& ec, std::size_t) {
                       // Otherwise this was the last reference.
                       if (!ec) self->guarded([&] { self->answer(); });
                     });
  }

 private:
  void leave() {
    if (place_) shared_->connections.erase(*std::exchange(place_, std::nullopt));
  }

  void answer() {
    stream_.expires_after(protocol::kAdminTimeout);  // for a picture over a slow line too
    keep_alive_ = parser_->get().keep_alive();
    answer_ = admin_answer(parser_->get(), shared_->pages);
    const std::array<asio::const_buffer, 2> buffers{asio::buffer(answer_.head),
                                                    asio::buffer(answer_.page.bytes())};
    asio::async_write(stream_, buffers,
                      [self = shared_from_this()](const error_code& ec, std::size_t) {
                        self->guarded([&] { self->on_written(ec); });
                      });
  }

  template <typename Step>
  void guarded(Step step) {
    try {
      step();
    } catch (const std::exception& error) {
      quietly([&] { common::log_error(common::LogKind::Accept, error.what()); });
      close();
    }
  }

  void on_written(const error_code& ec) {
    if (ec) return;
    answer_ = WebAnswer();  // it may hold a picture
    if (keep_alive_) return read();
    error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
  }

  beast::tcp_stream stream_;
  std::shared_ptr<Shared> shared_;
  std::optional<std::list<Connection*>::iterator> place_;
  beast::flat_buffer buffer_{kMaxHeaderBytes + kMaxBodyBytes};
  std::optional<http::request_parser<http::string_body>> parser_;
  WebAnswer answer_;
  bool keep_alive_ = false;
};

Admin::Admin(boost::asio::io_context& io, const common::HostPort& address,
             std::size_t max_connections, AdminPages pages)
    : shared_(std::make_shared<Shared>(Shared{std::move(pages), {}})),
      max_connections_(max_connections),
      accept_loop_(io, address, [this](tcp::socket socket) { accept(std::move(socket)); }) {}

void Admin::accept(tcp::socket socket) {
  if (shared_->connections.size() >= max_connections_) shared_->connections.front()->close();
  std::make_shared<Connection>(std::move(socket), shared_)->read();
}

void Admin::start() {
  accept_loop_.listen();
  accept_loop_.start();
}

}  // namespace amalgam::net
