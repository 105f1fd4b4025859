// A server for tests of the client: one connection after the other, each played by a script.
#pragma once

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <functional>
#include <optional>
#include <thread>
#include <vector>

#include "client/link/connection.h"
#include "protocol/framing.h"

namespace amalgam::client {

class FakePeer {
 public:
  explicit FakePeer(boost::asio::ip::tcp::socket socket) : socket_(std::move(socket)) {}

  // The next message but pongs; nothing if the client has closed.
  std::optional<protocol::Envelope> receive() {
    while (auto envelope = receive_one()) {
      if (!envelope->has_pong()) return envelope;
    }
    return std::nullopt;
  }

  // The next message.
  std::optional<protocol::Envelope> receive_one() {
    while (true) {
      protocol::Decoder::Result result = decoder_.next(input_);
      if (auto* envelope = std::get_if<protocol::Envelope>(&result)) {
        pongs += envelope->has_pong() ? 1 : 0;
        return std::move(*envelope);
      }
      if (std::holds_alternative<protocol::Decoder::Failure>(result)) return std::nullopt;
      boost::system::error_code ec;
      const std::size_t size = socket_.read_some(boost::asio::buffer(buffer_), ec);
      if (ec) return std::nullopt;
      input_ = std::span<const std::byte>(buffer_).first(size);
    }
  }

  void send(const protocol::Envelope& envelope) { send_bytes(protocol::encode(envelope)); }

  // False if the client has closed.
  bool send_bytes(const std::string& bytes) {
    boost::system::error_code ec;
    boost::asio::write(socket_, boost::asio::buffer(bytes), ec);
    return !ec;
  }

  // Waits until the client has handled all that was sent; for scripts that have sent no ping yet.
  void wait_for_pong() {
    protocol::Envelope ping;
    ping.mutable_ping()->set_nonce(1);
    send(ping);
    while (pongs == 0 && receive_one()) {
    }
  }

  // Takes the hello and welcomes.
  std::optional<protocol::Hello> welcome(const std::vector<int>& ids = {40}) {
    const auto hello = receive();
    if (!hello || !hello->has_hello()) return std::nullopt;
    protocol::Envelope envelope;
    protocol::Markers& markers = *envelope.mutable_welcome()->mutable_markers();
    markers.set_dictionary("DICT_6X6_250");
    markers.set_length(0.05);
    markers.set_world_marker(ids.front());
    markers.mutable_ids()->Add(ids.begin(), ids.end());
    send(envelope);
    return hello->hello();
  }

  // The frame's own bytes, as a server does that has nothing to add.
  void answer(const protocol::CameraFrame& frame) {
    protocol::Envelope envelope;
    protocol::Composite& composite = *envelope.mutable_composite();
    composite.set_frame_id(frame.frame_id());
    composite.set_capture_time_us(frame.capture_time_us());
    composite.set_jpeg(frame.jpeg());
    composite.set_unchanged(true);
    send(envelope);
  }

  // Answers frames until the client says goodbye or closes, at most this many.
  void answer_frames(int count = 1 << 30) {
    for (int i = 0; i < count; ++i) {
      const auto message = receive();
      if (!message || !message->has_camera_frame()) return;
      answer(message->camera_frame());
    }
  }

  int pongs = 0;

 private:
  boost::asio::ip::tcp::socket socket_;
  std::array<std::byte, 65536> buffer_{};
  std::span<const std::byte> input_;
  protocol::Decoder decoder_{protocol::limits_of_server()};
};

class FakeServer {
 public:
  using Script = std::function<void(FakePeer&)>;

  // A connection for each script, in order; after the last no more are accepted.
  explicit FakeServer(std::vector<Script> scripts)
      : acceptor_(io_, {boost::asio::ip::make_address("127.0.0.1"), 0}),
        thread_([this, scripts = std::move(scripts)] {
          for (const Script& script : scripts) {
            boost::system::error_code ec;
            boost::asio::ip::tcp::socket socket(io_);
            acceptor_.accept(socket, ec);
            if (ec) return;
            FakePeer peer(std::move(socket));
            script(peer);
          }
          boost::system::error_code ignored;
          acceptor_.close(ignored);
        }) {
    options_.server.port = acceptor_.local_endpoint().port();
  }
  // Scripts end when the client closes: destroy the Connection first.
  ~FakeServer() { thread_.join(); }

  ConnectionOptions options(std::chrono::milliseconds connect_timeout) const {
    ConnectionOptions options = options_;
    options.connect_timeout = connect_timeout;
    return options;
  }

 private:
  boost::asio::io_context io_;
  boost::asio::ip::tcp::acceptor acceptor_;
  ConnectionOptions options_;
  std::thread thread_;
};

}  // namespace amalgam::client
