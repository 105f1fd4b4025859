#include "net/admin.h"

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

namespace beast = boost::beast;
namespace http = beast::http;
using boost::asio::ip::tcp;
using boost::system::error_code;
using Response = http::response<http::string_body>;

constexpr std::uint32_t kMaxHeaderBytes = 8 * 1024;  // browsers stay below
constexpr std::uint64_t kMaxBodyBytes = 1024;        // no page takes one

struct Page {
  http::status status;
  const char* type;
  std::string text;
};

Page page_for(const std::string& target, const AdminPages& pages) {
  const std::string path = target.substr(0, target.find('?'));
  if (path == "/livez" || path == "/readyz") {
    const std::string reason = path == "/livez" ? pages.not_alive() : pages.not_ready();
    if (reason.empty()) return {http::status::ok, "text/plain", "ok\n"};
    return {http::status::service_unavailable, "text/plain", reason + "\n"};
  }
  if (path == "/metrics") {
    return {http::status::ok, "text/plain; version=0.0.4; charset=utf-8", pages.metrics()};
  }
  if (path == "/state") return {http::status::ok, "application/json", pages.state() + "\n"};
  return {http::status::not_found, "text/plain", "/livez /readyz /metrics /state\n"};
}

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
    const auto& request = parser_->get();
    response_ = Response(http::status::ok, request.version());
    response_.keep_alive(request.keep_alive());
    if (request.method() == http::verb::get || request.method() == http::verb::head) {
      Page page = page_for(std::string(request.target()), shared_->pages);
      response_.result(page.status);
      response_.set(http::field::content_type, page.type);
      response_.body() = std::move(page.text);
    } else {
      response_.result(http::status::method_not_allowed);
    }
    response_.prepare_payload();
    if (request.method() == http::verb::head) response_.body().clear();
    http::async_write(stream_, response_,
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
    if (response_.keep_alive()) return read();
    error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
  }

  beast::tcp_stream stream_;
  std::shared_ptr<Shared> shared_;
  std::optional<std::list<Connection*>::iterator> place_;
  beast::flat_buffer buffer_{kMaxHeaderBytes + kMaxBodyBytes};
  std::optional<http::request_parser<http::string_body>> parser_;
  Response response_;
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
