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
#include "net/agent_check.h"
#include "net/connection.h"
#include "net/connection_limits.h"
#include "net/listener.h"
#include "net/made_files.h"
#include "net/memory_trim.h"
#include "net/metrics.h"
#include "net/quietly.h"
#include "net/status.h"
#include "net/supervisor.h"
#include "net/tcp_transport.h"
#include "net/tls.h"
#include "net/web_request.h"
#include "net/web_transport.h"
#include "net/wire.h"
#include "protocol/framing.h"

namespace amalgam::net {

namespace asio = boost::asio;

class Server::Impl {
 public:
  explicit Impl(const ServerConfig& config)
      : config_(config),
        limits_(config.connections),
        admission_(config.admission),
        recorder_(config.record),
        tls_(make_tls_context(config.tls)),
        admin_(io_, config.admin, config.connections.admin,
               {.not_alive = [this] { return status_.not_alive(); },
                .not_ready = [this] { return status_.not_ready(phase_); },
                .metrics = [this] { return metrics_.text(status_.gauges()); },
                .state = [this] { return state(); },
                .picture = [this](std::uint64_t session) { return picture(session); },
                .files = config.status_files}),
        listener_(
            io_, config.listen, config_, limits_, back_off_, metrics_,
            [](std::chrono::milliseconds retry_after, const std::string& reason) {
              return protocol::encode(busy_message(retry_after, reason));
            },
            [this](Listener::Admitted admitted) {
              auto transport = std::make_unique<TcpTransport>(std::move(admitted.socket), tls_);
              admit(std::move(admitted), std::move(transport));
            }),
        signals_(io_),
        drain_timer_(io_),
        tick_timer_(io_) {
    if (config.agent) {
      agent_.emplace(io_, *config.agent, [this] { return status_.agent_answer(phase_); });
    }
    if (config.web) listen_to_browsers(*config.web);
    admin_.start();
    if (agent_) agent_->start();
  }

  // Sessions give their views back while the service and the counts are still there.
  ~Impl() { end_sessions(); }

  void serve(frame::FrameService& service) {
    listener_.listen();  // here, so that the caller can tell the world, or learns that it failed
    if (web_) web_->listen();
    asio::post(io_, [this, &service] {
      if (phase_ != Phase::Loading) return;
      status_.set_service(service);
      context_.emplace(ServerContext{config_, service, metrics_, admission_, false, &recorder_});
      shared_.emplace(Connection::Shared{*context_, limits_, back_off_});
      listener_.start();
      if (web_) web_->start();
      phase_ = Phase::Serving;
      tell_supervisor(ServiceState::Ready);
    });
  }

  // What is thrown past all guards, because memory is missing, ends nothing but the step that
  // threw.
  void run() {
    bool lost_handlers = true;  // at first: none waits yet
    for (;;) {
      try {
        if (std::exchange(lost_handlers, false)) restart();
        io_.run();
        return;
      } catch (const std::exception& error) {
        lost_handlers = true;
        quietly([&] { common::log_error(common::LogKind::Accept, error.what()); });
      }
    }
  }

  void handle_signals(std::function<void()> reload) {
    reload_ = std::move(reload);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) signals_.add(signal);
  }

  void configure(const ServerConfig& config, TlsContext tls) {
    const common::HostPort listen = config_.listen, admin = config_.admin;
    const auto agent = config_.agent, web = config_.web;
    config_ = config;
    config_.listen = listen;
    config_.admin = admin;
    config_.agent = agent;
    config_.web = web;
    tls_ = std::move(tls);
    limits_.set_caps(config.connections);
    admission_.set_limits(config.admission);
    recorder_.reloaded(config.record);
    admin_.set_max_connections(config.connections.admin);
    made_.forget();
    if (config.admin_pictures) return;
    for (const auto& [id, session] : sessions_) session->forget_picture();
  }

  void reload_ended(const std::optional<std::string>& error) {
    metrics_.reloaded(!error);
    error ? common::log_error("reload: the old scene and configuration stay: " + *error)
          : common::log_info("reloaded");
    if (phase_ == Phase::Serving) tell_supervisor(ServiceState::Ready);
  }

  void post(std::function<void()> step) { asio::post(io_, std::move(step)); }
  void drain() {
    asio::post(io_, [this] { begin_drain(); });
  }
  void stop() {
    asio::post(io_, [this] { finish(); });
  }

  common::HostPort address() const { return listener_.address(); }
  common::HostPort admin_address() const { return admin_.address(); }
  std::optional<common::HostPort> agent_address() const {
    return agent_ ? std::optional(agent_->address()) : std::nullopt;
  }

  std::optional<common::HostPort> web_address() const {
    return web_ ? std::optional(web_->address()) : std::nullopt;
  }

 private:
  void listen_to_browsers(const common::HostPort& address) {
    web_.emplace(io_, address, config_, limits_, back_off_, metrics_, busy_answer,
                 [this](Listener::Admitted admitted) {
                   auto transport = std::make_unique<WebTransport>(std::move(admitted.socket), tls_,
                                                                   config_.web_options, made_);
                   admit(std::move(admitted), std::move(transport));
                 });
  }

  void admit(Listener::Admitted admitted, std::unique_ptr<Transport> transport) {
    metrics_.connected(transport->name());
    const std::uint64_t id = ++last_session_;
    const auto session = std::make_shared<Connection>(
        std::move(transport), std::move(admitted.ticket), admitted.by_proxy, id, *shared_,
        [this](std::uint64_t ended) { on_end(ended); });
    sessions_.emplace(id, session);
    session->start();
  }

  void on_end(std::uint64_t session) {
    sessions_.erase(session);
    memory_trim_.left_behind();
    if (phase_ == Phase::Draining && sessions_.empty()) finish();
  }

  void wait_for_signal() {
    signals_.async_wait([this](const boost::system::error_code& ec, int signal) {
      if (ec) return;
      if (signal == SIGHUP) {
        wait_for_signal();
        if (phase_ != Phase::Serving) return;
        tell_supervisor(ServiceState::Reloading);
        return reload_();
      }
      if (phase_ != Phase::Serving) {
        // Asked twice, or nothing is served yet that could be finished. Rendering or loading may be
        // in the middle of something long, so nobody is waited for.
        std::_Exit(phase_ == Phase::Loading ? EXIT_SUCCESS : EXIT_FAILURE);
      }
      begin_drain();
      wait_for_signal();
    });
  }

  // Everything that always waits, waits anew.
  void restart() {
    boost::system::error_code ignored;
    signals_.cancel(ignored);
    if (reload_) wait_for_signal();
    admin_.restart();
    if (agent_) agent_->restart();
    listener_.restart();
    if (web_) web_->restart();
    tick();
  }

  // Twice a second.
  void tick() {
    if (phase_ == Phase::Finished) return;
    // Whoever restarts silent services hears nothing of one whose renderer is stuck.
    if (status_.not_alive().empty()) tell_supervisor(ServiceState::Alive);
    if (context_ && std::exchange(context_->large_messages, false)) memory_trim_.left_behind();
    memory_trim_.tick(std::chrono::steady_clock::now());
    tick_timer_.expires_after(std::chrono::milliseconds(500));
    tick_timer_.async_wait([this](const boost::system::error_code& ec) {
      if (!ec) tick();
    });
  }

  void begin_drain() {
    if (phase_ != Phase::Serving && phase_ != Phase::Loading) return;
    tell_supervisor(ServiceState::Stopping);
    if (phase_ == Phase::Loading || config_.drain_delay.count() == 0) return drain_sessions();
    common::log_info("leaving: not ready any more, draining in " +
                     std::to_string(config_.drain_delay.count()) + " ms");
    phase_ = Phase::Leaving;
    drain_timer_.expires_after(config_.drain_delay);
    drain_timer_.async_wait([this](const boost::system::error_code& ec) {
      if (!ec && phase_ == Phase::Leaving) drain_sessions();
    });
  }

  void drain_sessions() {
    common::log_info("draining " + std::to_string(sessions_.size()) + " sessions");
    phase_ = Phase::Draining;
    close_listeners();
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
    close_listeners();
    end_sessions();
    boost::system::error_code ignored;
    signals_.clear(ignored);  // nobody would hear the next one: let it end the process by itself
    io_.stop();
  }

  void close_listeners() {
    listener_.close();
    if (web_) web_->close();
  }

  void end_sessions() {
    for (const auto& session : copy_of_sessions()) session->end();
  }

  std::vector<std::shared_ptr<Connection>> copy_of_sessions() const {
    std::vector<std::shared_ptr<Connection>> copy;
    for (const auto& [id, session] : sessions_) copy.push_back(session);
    return copy;
  }

  std::string state() const {
    std::vector<SessionReport> sessions;
    for (const auto& [id, session] : sessions_) sessions.push_back(session->report());
    return status_.state(phase_, std::move(sessions));
  }

  Picture picture(std::uint64_t session) const {
    if (!config_.admin_pictures) return "no pictures are kept: that takes --admin-pictures";
    const auto found = sessions_.find(session);
    auto picture = found == sessions_.end() ? nullptr : found->second->picture();
    if (picture) return picture;
    return "session " + std::to_string(session) + " is not there, or without a composite";
  }

  // In the order of dependence: what is destroyed first may still use what stands above it.
  ServerConfig config_;
  Metrics metrics_;
  ConnectionLimits limits_;
  BackOff back_off_;
  Admission admission_;
  record::Recorder recorder_;
  Status status_{config_, limits_, admission_, recorder_};
  std::shared_ptr<asio::ssl::context> tls_;
  std::optional<ServerContext> context_;
  std::optional<Connection::Shared> shared_;
  Phase phase_ = Phase::Loading;
  std::uint64_t last_session_ = 0;
  std::function<void()> reload_;
  MemoryTrim memory_trim_;
  asio::io_context io_{1};  // one thread: no locks on sockets
  MadeFiles made_{io_, [this] { return context_->service.markers(); }};
  std::map<std::uint64_t, std::shared_ptr<Connection>> sessions_;
  Admin admin_;
  std::optional<AgentCheck> agent_;
  Listener listener_;
  std::optional<Listener> web_;
  asio::signal_set signals_;
  asio::steady_timer drain_timer_;
  asio::steady_timer tick_timer_;
};

Server::Server(const ServerConfig& config) : impl_(std::make_unique<Impl>(config)) {}
Server::~Server() = default;

void Server::serve(frame::FrameService& service) {
  impl_->serve(service);
}
void Server::run() {
  impl_->run();
}
void Server::handle_signals(std::function<void()> reload) {
  impl_->handle_signals(std::move(reload));
}
void Server::post(std::function<void()> step) {
  impl_->post(std::move(step));
}
void Server::configure(const ServerConfig& config, TlsContext tls) {
  impl_->configure(config, std::move(tls));
}
void Server::reload_ended(const std::optional<std::string>& error) {
  impl_->reload_ended(error);
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
std::optional<common::HostPort> Server::agent_address() const {
  return impl_->agent_address();
}
std::optional<common::HostPort> Server::web_address() const {
  return impl_->web_address();
}

}  // namespace amalgam::net
