#include "net/server.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "common/log.h"
#include "net/admin.h"
#include "net/connection.h"
#include "net/connection_limits.h"
#include "net/listener.h"
#include "net/metrics.h"
#include "net/state_page.h"

namespace amalgam::net {
namespace {

namespace asio = boost::asio;
using Clock = std::chrono::steady_clock;

}  // namespace

class Server::Impl {
 public:
  explicit Impl(const ServerConfig& config)
      : config_(config),
        limits_(config.connections),
        admin_(io_, config.admin, config.connections.admin,
               {.not_ready = [this] { return not_ready(); },
                .metrics = [this] { return metrics_.text(); },
                .state = [this] { return state(); }}),
        listener_(io_, config.listen, limits_, metrics_,
                  [this](asio::ip::tcp::socket socket, ConnectionLimits::Ticket ticket) {
                    admit(std::move(socket), std::move(ticket));
                  }),
        signals_(io_),
        drain_timer_(io_) {
    admin_.start();
  }

  // Sessions give their views back while the service and the counts are still there.
  ~Impl() { end_sessions(); }

  void serve(frame::FrameService& service) {
    listener_.listen();  // here, so that the caller can tell the world, or learns that it failed
    asio::post(io_, [this, &service] {
      if (phase_ != Phase::Loading) return;
      context_.emplace(ServerContext{config_, service, metrics_});
      listener_.start();
      phase_ = Phase::Serving;
    });
  }

  void run() { io_.run(); }

  void drain_on_signals() {
    signals_.add(SIGTERM);
    signals_.add(SIGINT);
    wait_for_signal();
  }

  void drain() {
    asio::post(io_, [this] { begin_drain(); });
  }
  void stop() {
    asio::post(io_, [this] { finish(); });
  }

  common::HostPort address() const { return listener_.address(); }
  common::HostPort admin_address() const { return admin_.address(); }

 private:
  enum class Phase { Loading, Serving, Draining, Finished };

  void admit(asio::ip::tcp::socket socket, ConnectionLimits::Ticket ticket) {
    const std::uint64_t id = ++last_session_;
    const auto session =
        std::make_shared<Connection>(std::move(socket), std::move(ticket), id, *context_,
                                     [this](std::uint64_t ended) { on_end(ended); });
    sessions_.emplace(id, session);
    session->start();
  }

  void on_end(std::uint64_t session) {
    sessions_.erase(session);
    if (phase_ == Phase::Draining && sessions_.empty()) finish();
  }

  void wait_for_signal() {
    signals_.async_wait([this](const boost::system::error_code& ec, int) {
      if (ec) return;
      if (phase_ != Phase::Serving) {
        // Asked twice, or nothing is served yet that could be finished. Rendering or loading may be
        // in the middle of something long, so nobody is waited for.
        std::_Exit(phase_ == Phase::Loading ? EXIT_SUCCESS : EXIT_FAILURE);
      }
      begin_drain();
      wait_for_signal();
    });
  }

  void begin_drain() {
    if (phase_ != Phase::Serving && phase_ != Phase::Loading) return;
    common::log_info("draining " + std::to_string(sessions_.size()) + " sessions");
    phase_ = Phase::Draining;
    listener_.close();
    // A copy: sessions leave the map as they end.
    for (const auto& session : copy_of_sessions()) session->drain(config_.drain_timeout);
    if (sessions_.empty()) return finish();
    drain_timer_.expires_after(config_.drain_timeout);
    drain_timer_.async_wait([this](const boost::system::error_code& ec) {
      if (!ec) finish();
    });
  }

  void finish() {
    if (std::exchange(phase_, Phase::Finished) == Phase::Finished) return;
    listener_.close();
    end_sessions();
    boost::system::error_code ignored;
    signals_.clear(ignored);  // nobody would hear the next one: let it end the process by itself
    io_.stop();
  }

  void end_sessions() {
    for (const auto& session : copy_of_sessions()) session->end();
  }

  std::vector<std::shared_ptr<Connection>> copy_of_sessions() const {
    std::vector<std::shared_ptr<Connection>> copy;
    for (const auto& [id, session] : sessions_) copy.push_back(session);
    return copy;
  }

  std::string not_ready() const {
    switch (phase_) {
      case Phase::Loading:
        return "loading";
      case Phase::Serving:
        return limits_.full() ? "full" : "";
      case Phase::Draining:
      case Phase::Finished:
        return "draining";
    }
    return "";
  }

  std::string state() const {
    ServerReport report;
    report.not_ready = not_ready();
    report.ray_tracer = config_.ray_tracer;
    report.uptime = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - started_);
    report.connections = limits_.total();
    for (const auto& [id, session] : sessions_) report.sessions.push_back(session->report());
    return state_json(report);
  }

  // In the order of dependence: what is destroyed first may still use what stands above it.
  ServerConfig config_;
  Metrics metrics_;
  ConnectionLimits limits_;
  std::optional<ServerContext> context_;
  Clock::time_point started_ = Clock::now();
  Phase phase_ = Phase::Loading;
  std::uint64_t last_session_ = 0;
  asio::io_context io_{1};  // one thread: no locks on sockets
  std::map<std::uint64_t, std::shared_ptr<Connection>> sessions_;
  Admin admin_;
  Listener listener_;
  asio::signal_set signals_;
  asio::steady_timer drain_timer_;
};

Server::Server(const ServerConfig& config) : impl_(std::make_unique<Impl>(config)) {}
Server::~Server() = default;

void Server::serve(frame::FrameService& service) {
  impl_->serve(service);
}
void Server::run() {
  impl_->run();
}
void Server::drain_on_signals() {
  impl_->drain_on_signals();
}
void Server::drain() {
  impl_->drain();
}
void Server::stop() {
  impl_->stop();
}
common::HostPort Server::address() const {
  return impl_->address();
}
common::HostPort Server::admin_address() const {
  return impl_->admin_address();
}

}  // namespace amalgam::net
