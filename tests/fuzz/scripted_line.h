// What net::Connection does between its socket and its conversation, without socket and timer. It
// checks that every frame is accounted for, that nothing is said after the last word, and that what
// was taken is given back.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/scripted_service.h"
#include "net/conversation.h"
#include "net/wire.h"
#include "net/write_slot.h"
#include "protocol/framing.h"
#include "protocol/limits.h"

namespace amalgam::fuzz {

class ScriptedLine : private net::Line {
 public:
  ScriptedLine(const net::ServerConfig& config, net::Metrics& metrics)
      : admission_(config.admission), context_{config, service_, metrics, admission_, false} {}
  ~ScriptedLine() override {
    while (!steps_.empty()) run_step();
    end();
    check_frames();
  }

  // An Envelope arrives.
  void receive(std::span<const std::byte> envelope) {
    if (state_ != State::Open) return;
    std::vector<std::byte> bytes;
    for (std::size_t i = 0; i < protocol::kLengthBytes; ++i) {
      bytes.push_back(static_cast<std::byte>(envelope.size() >> 8 * i & 0xff));
    }
    bytes.insert(bytes.end(), envelope.begin(), envelope.end());
    std::span<const std::byte> input = bytes;
    const protocol::Decoder::Result result = decoder_.next(input);
    guarded([&] {
      if (const auto* failure = std::get_if<protocol::Decoder::Failure>(&result)) {
        throw net::ClientError(protocol::Error::PROTOCOL_ERROR, failure->what);
      }
      if (const auto* refused = std::get_if<protocol::Decoder::TooManyPoses>(&result)) {
        return conversation_.refuse_poses(refused->frame_id, refused->message_bytes);
      }
      conversation_.visit(std::get<protocol::Envelope>(result));
    });
  }

  void finish_frame(frame::FrameResult result) { service_.finish_frame(std::move(result)); }
  void finish_environment(bool good) {
    service_.finish_environment(good ? std::nullopt : std::optional<std::string>("bad"));
  }

  // One step of the renderer's reaches the line's thread.
  void run_step() {
    if (steps_.empty()) return;
    const Step step = std::move(steps_.front());
    steps_.pop_front();
    if (state_ != State::Ended) guarded(step);
  }

  // The socket takes what is being written, or is given the next.
  void write() {
    if (state_ == State::Ended) return;
    if (!writing_) {
      writing_ = slot_.begin_write(conversation_.skipped());
      if (slot_.writing_answer()) answer_waits_ = false;
      return;
    }
    if (slot_.writing_answer()) conversation_.written(writing_->size());
    slot_.end_write();
    writing_.reset();
  }

  void drain() {
    if (state_ == State::Open) guarded([&] { conversation_.drain(protocol::kDrainTimeout); });
  }

  // The connection is lost.
  void end() {
    if (std::exchange(state_, State::Ended) == State::Ended) return;
    leave();
  }

  void check_frames() const {
    const net::SessionReport report = conversation_.report();
    const bool writing_answer = writing_ && slot_.writing_answer();
    const std::uint64_t known = report.sent + report.skipped + report.in_flight +
                                (answer_waits_ ? 1u : 0u) + (writing_answer ? 1u : 0u);
    AMALGAM_CHECK(report.received == known, std::to_string(report.received) + " frames came, " +
                                                std::to_string(known) + " are accounted for");
    AMALGAM_CHECK(service_.open_views() <= 1, "a session has two views");
  }

 private:
  enum class State { Open, Closing, Ended };

  void send(const protocol::Envelope& message) override {
    AMALGAM_CHECK(state_ == State::Open, "said after the last word");
    slot_.put_control(message);
  }
  bool send_answer(net::Answer answer) override {
    AMALGAM_CHECK(state_ == State::Open, "answered after the last word");
    answer_waits_ = true;
    return slot_.put_answer(std::move(answer));
  }
  void send_last(const protocol::Envelope& message) override {
    slot_.drop_control();
    send(message);
    close();
  }
  void welcomed() override {
    AMALGAM_CHECK(!std::exchange(welcomed_, true), "welcomed twice");
    decoder_.set_limits(protocol::limits_of_server());
  }
  void refused() override { AMALGAM_CHECK(!welcomed_, "refused after the welcome"); }
  void heard_pong(std::uint64_t) override { AMALGAM_CHECK(welcomed_, "a pong before the welcome"); }
  void close() override {
    if (state_ != State::Open) return;
    state_ = State::Closing;
    leave();
  }
  std::function<void(Step)> posting() override {
    return [this](Step step) { steps_.push_back(std::move(step)); };
  }

  void leave() {
    if (slot_.drop_answer()) conversation_.dropped();
    answer_waits_ = false;
    conversation_.leave();
    AMALGAM_CHECK(service_.open_views() == 0, "the view is kept");
    AMALGAM_CHECK(admission_.memory() == 0, "memory is kept");
  }

  template <typename F>
  void guarded(F step) {
    try {
      step();
    } catch (const net::ClientError& error) {
      conversation_.answer(error);
    }
  }

  ScriptedService service_;
  net::Admission admission_;
  net::ServerContext context_;
  State state_ = State::Open;
  bool welcomed_ = false;
  bool answer_waits_ = false;  // in the slot
  protocol::Decoder decoder_{protocol::limits_before_hello()};
  net::WriteSlot slot_{protocol::kMaxQueuedControl};
  std::optional<std::string> writing_;
  std::deque<Step> steps_;
  net::Conversation conversation_{1, "fuzzer", *this, context_};
};

}  // namespace amalgam::fuzz
