// What a client and the server say to each other: messages, poses, frames on their way to the
// renderer and back. Knows neither sockets nor timers, which are the Line's.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/rate_limit.h"
#include "frame/frame.h"
#include "net/admission.h"
#include "net/answer.h"
#include "net/capture_clock.h"
#include "net/client_error.h"
#include "net/corner_poses.h"
#include "net/environment_slot.h"
#include "net/frame_ledger.h"
#include "net/metrics.h"
#include "net/own_light.h"
#include "net/pose_hold.h"
#include "net/server_config.h"
#include "net/session_figures.h"
#include "net/session_report.h"
#include "record/recorder.h"
#include "record/session_recording.h"

namespace amalgam::net {

// Shared by all sessions. Outlives them.
struct ServerContext {
  const ServerConfig& config;
  frame::FrameService& service;
  Metrics& metrics;
  Admission& admission;
  bool large_messages = false;           // some came, and may have left memory in the allocator
  record::Recorder* recorder = nullptr;  // null: no session is recorded
};

// What a conversation needs of the connection that carries it.
class Line {
 public:
  using Step = std::function<void()>;

  virtual ~Line() = default;
  virtual void send(const protocol::Envelope& message) = 0;
  // True if it replaced a waiting one, which will never be written.
  virtual bool send_answer(Answer answer) = 0;
  // An Error or Busy that ends the conversation: nothing else that waits is written before it.
  virtual void send_last(const protocol::Envelope& message) = 0;
  // The hello was accepted, and the Welcome sent: larger messages are taken and the client is
  // pinged, at once for the first time.
  virtual void welcomed() = 0;
  // The client gave a wrong token, or failed to prove what it had to.
  virtual void refused() = 0;
  // The client has read everything up to the ping with this nonce.
  virtual void heard_pong(std::uint64_t nonce) = 0;
  // Writes what is queued, then ends. Calls Conversation::leave().
  virtual void close() = 0;
  // A function for other threads. It runs a step on the line's own, if the line still lives then.
  virtual std::function<void(Step)> posting() = 0;
};

class Conversation {
 public:
  Conversation(std::uint64_t id, std::string peer, Line& line, ServerContext& context);
  ~Conversation() { leave(); }
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  // Throws ClientError, which the line hands to answer().
  void visit(const protocol::Envelope& envelope);
  // A frame that was not even kept. Throws ClientError.
  void refuse_poses(std::uint64_t frame_id, std::size_t message_bytes);
  void answer(const ClientError& error);

  // Accepts no more frames; answers those in flight.
  void drain(std::chrono::milliseconds deadline);
  // True if nothing more will be said while draining. The line may still have something to write.
  bool drained() const { return state_ == State::Draining && ledger_.in_flight() == 0; }
  // Gives the view back; frames in flight are never answered.
  void leave();

  // A message was put behind those that wait to be written, or dropped because they are too many.
  void said(const protocol::Envelope& message) { recording_.sent(message); }
  void not_said() const;

  // What became of an Answer: its writing begins, with a ping behind it.
  void writing(const protocol::Envelope& ping);
  void written(std::size_t message_bytes);
  void dropped() { ledger_.skip(Skip::Closed); }

  void set_peer(std::string peer) { peer_ = std::move(peer); }
  std::uint64_t skipped() const { return ledger_.skipped_count(); }
  std::string name() const;  // for logs
  SessionReport report() const;
  // The last composite, if the operator wants to see them; null: there is none.
  std::shared_ptr<const frame::Bytes> picture() const { return picture_; }
  void forget_picture() { picture_.reset(); }

 private:
  using Clock = std::chrono::steady_clock;
  enum class State { AwaitingHello, Running, Draining, Over };  // in this order only

  void on_hello(const protocol::Hello& hello);
  void on_camera_frame(const protocol::CameraFrame& frame);
  void on_environment(const protocol::Environment& environment);
  void check_environment_right(bool own);
  void apply(std::optional<frame::EnvironmentInput> environment);
  std::vector<common::MarkerPose> usable_poses(const protocol::CameraFrame& frame,
                                               const FrameLedger::Entry& entry);
  CornerPoses::Solved solve(const protocol::CameraFrame& frame, const FrameLedger::Entry& entry);

  template <typename... Args>
  std::function<void(Args...)> posting(void (Conversation::*handler)(Args...));
  void on_environment_applied(std::optional<std::string> error);
  void on_rendered(std::uint64_t ticket, frame::FrameResult result);
  void send_composite(FrameLedger::Entry frame, frame::FrameOutput output);
  ClientError told_of(const frame::FrameFailure& failure, std::uint64_t frame_id) const;
  void keep_picture(const frame::Bytes& jpeg);

  std::uint64_t id_;
  std::string peer_;
  Line& line_;
  ServerContext& context_;

  State state_ = State::AwaitingHello;
  std::optional<frame::ViewId> view_;
  common::CameraModel camera_;
  Rights rights_;
  std::optional<CornerPoses> corner_poses_;  // from the hello on
  PoseHold pose_hold_;
  CaptureClock capture_clock_;
  EnvironmentSlot environments_;
  OwnLight own_light_;
  common::RateLimit environment_rate_;
  FrameLedger ledger_;
  record::SessionRecording recording_;
  Clock::time_point begun_ = Clock::now();
  SessionFigures figures_;
  std::shared_ptr<const frame::Bytes> picture_;
};

}  // namespace amalgam::net
