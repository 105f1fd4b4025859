#include "client/link/connection.h"

#include <algorithm>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <iterator>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>

#include "client/link/event_queue.h"
#include "client/link/link.h"
#include "common/mailbox.h"
#include "protocol/client_tls.h"

namespace amalgam::client {
namespace {

namespace asio = boost::asio;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

// Finds a restarted server within a second, without all clients coming at once.
constexpr milliseconds kFirstBackoff{50};
constexpr milliseconds kMaxBackoff{1000};

// Errors that wait for the viewer; further ones are dropped. A frame has two at most.
constexpr std::size_t kMaxWaitingErrors = 64;

struct QueuedFrame {
  std::uint64_t id = 0;
  std::string bytes;
};

}  // namespace

class Connection::Worker {
 public:
  Worker(const ConnectionOptions& options, const protocol::Hello& hello)
      : options_(options),
        hello_(hello),
        tls_(options.tls ? protocol::client_tls(options.certificate_authority) : nullptr),
        work_(io_.get_executor()),
        retry_timer_(io_) {}

  void start() {
    give_up_at_ = Clock::now() + options_.connect_timeout;
    asio::post(io_, [this] { open(); });
    thread_ = std::thread([this] {
      try {
        io_.run();
      } catch (const std::exception& error) {  // out of memory, at best
        give_up(error.what());
      }
    });
  }

  void stop() {
    asio::post(io_, [this] {
      stopping_ = true;
      retry_timer_.cancel();
      if (link_) link_->close();
      work_.reset();
    });
    thread_.join();
  }

  std::optional<std::uint64_t> send(QueuedFrame frame) {
    const auto replaced = mailbox_.put(std::move(frame));
    asio::post(io_, [this] { write_waiting(); });
    return replaced ? std::optional(replaced->id) : std::nullopt;
  }

  std::optional<ConnectionEvent> wait(milliseconds timeout) { return events_.wait(timeout); }

 private:
  void open() {
    if (stopping_) return;
    Link::Events events;
    events.welcomed = [this](protocol::Welcome welcome) {
      backoff_ = kFirstBackoff;
      was_welcomed_ = true;
      if (!options_.after_welcome.empty()) link_->write_first(options_.after_welcome);
      events_.push(Welcomed{std::move(welcome)});
    };
    events.composite = [this](protocol::Composite composite) {
      if (!is_asked_for(composite.frame_id())) return;
      events_.push(Composited{std::move(composite), Clock::now()});
    };
    events.error = [this](protocol::Error error) {
      if (events_.size() < kMaxWaitingErrors) events_.push(FrameError{std::move(error)});
    };
    events.idle = [this] { write_waiting(); };
    events.ended = [this](const LinkEnd& end) { on_end(end); };
    link_ = std::make_shared<Link>(io_, tls_, std::move(events));
    was_welcomed_ = false;
    unanswered_.clear();
    const auto left = std::chrono::duration_cast<milliseconds>(give_up_at_ - Clock::now());
    link_->open(options_.server, hello_, std::max(left, milliseconds(1)));
  }

  void write_waiting() {
    if (!link_ || !link_->is_idle()) return;
    if (auto frame = mailbox_.take()) {
      last_sent_ = frame->id;
      unanswered_.insert(frame->id);
      link_->write_frame(std::move(frame->bytes));
    }
  }

  // Composites of up to 32 MiB wait for the viewer: only those that it asked for, and once. Answers
  // keep the order of the frames, so none is left of earlier ones.
  bool is_asked_for(std::uint64_t frame_id) {
    const auto frame = unanswered_.find(frame_id);
    if (frame == unanswered_.end()) return false;
    unanswered_.erase(unanswered_.begin(), std::next(frame));
    return true;
  }

  void on_end(const LinkEnd& end) {
    if (stopping_) return;
    if (end.kind == LinkEnd::Kind::Refused) return give_up(end.text);
    if (was_welcomed_) give_up_at_ = Clock::now() + options_.connect_timeout;
    const milliseconds pause = std::max(next_backoff(), later(end.retry_after));
    if (Clock::now() + pause >= give_up_at_) return give_up(end.text);
    if (was_welcomed_) events_.push(LinkBroken{end.text, last_sent_});
    retry_timer_.expires_after(pause);
    retry_timer_.async_wait([this](const boost::system::error_code& ec) {
      if (!ec) open();
    });
  }

  void give_up(const std::string& text) {
    events_.push(GaveUp{to_string(options_.server) + ": " + text});
  }

  // Doubles each time; a random half of it is left out, so that clients spread.
  milliseconds next_backoff() {
    std::uniform_real_distribution<double> part(0.5, 1.0);
    const milliseconds pause(
        static_cast<milliseconds::rep>(part(random_) * static_cast<double>(backoff_.count())));
    backoff_ = std::min(2 * backoff_, kMaxBackoff);
    return pause;
  }

  // Not before the server's time, and not all at once: up to half of it later.
  milliseconds later(milliseconds retry_after) {
    std::uniform_real_distribution<double> times(1.0, 1.5);
    return milliseconds(
        static_cast<milliseconds::rep>(times(random_) * static_cast<double>(retry_after.count())));
  }

  const ConnectionOptions options_;
  const protocol::Hello hello_;
  const protocol::Stream::Tls tls_;
  common::Mailbox<QueuedFrame> mailbox_;
  EventQueue<ConnectionEvent> events_;
  std::thread thread_;

  // The network thread's own.
  asio::io_context io_;
  asio::executor_work_guard<asio::io_context::executor_type> work_;
  asio::steady_timer retry_timer_;
  std::shared_ptr<Link> link_;
  std::mt19937 random_{std::random_device{}()};
  milliseconds backoff_ = kFirstBackoff;
  Clock::time_point give_up_at_;
  std::uint64_t last_sent_ = 0;
  std::set<std::uint64_t> unanswered_;  // sent over this link
  bool was_welcomed_ = false;
  bool stopping_ = false;
};

Connection::Connection(const ConnectionOptions& options, const protocol::Hello& hello)
    : worker_(std::make_unique<Worker>(options, hello)) {
  worker_->start();
}

Connection::~Connection() {
  worker_->stop();
}

std::optional<std::uint64_t> Connection::send(std::uint64_t frame_id, std::string bytes) {
  return worker_->send({frame_id, std::move(bytes)});
}

std::optional<ConnectionEvent> Connection::wait(milliseconds timeout) {
  return worker_->wait(timeout);
}

}  // namespace amalgam::client
