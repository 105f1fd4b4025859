#include "support/net/test_client.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "protocol/limits.h"
#include "support/net/web_wire.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;

constexpr timeval kPatience{.tv_sec = 10, .tv_usec = 0};

int connect_to(const common::HostPort& server, int receive_buffer) {
  const int handle = ::socket(AF_INET, SOCK_STREAM, 0);
  ::setsockopt(handle, SOL_SOCKET, SO_RCVTIMEO, &kPatience, sizeof(kPatience));
  ::setsockopt(handle, SOL_SOCKET, SO_SNDTIMEO, &kPatience, sizeof(kPatience));
  if (receive_buffer > 0) {
    ::setsockopt(handle, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof(receive_buffer));
  }
  const int now = 1;  // or small messages would wait for an acknowledgement, and figures be wrong
  ::setsockopt(handle, IPPROTO_TCP, TCP_NODELAY, &now, sizeof(now));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(server.port);
  ::inet_pton(AF_INET, server.host.c_str(), &address.sin_addr);
  if (::connect(handle, reinterpret_cast<sockaddr*>(&address), sizeof(address)) != 0) {
    ::close(handle);
    throw std::runtime_error("connect to " + to_string(server) + ": " + std::strerror(errno));
  }
  return handle;
}

// Waits as long as a blocking socket would.
bool wait_for(short events, int handle) {
  pollfd waiting{.fd = handle, .events = events, .revents = 0};
  return ::poll(&waiting, 1, static_cast<int>(kPatience.tv_sec) * 1000) == 1;
}

// To the end of the stream, and closes it.
std::string take_all(int handle) {
  std::string text;
  std::array<char, 4096> buffer;
  for (ssize_t size = 0; (size = ::recv(handle, buffer.data(), buffer.size(), 0)) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(size));
  }
  ::close(handle);
  return text;
}

}  // namespace

TestClient::TestClient(const common::HostPort& server, int receive_buffer, Over over,
                       const std::string& first)
    : socket_(connect_to(server, receive_buffer)) {
  send_raw(first);
  if (over == Over::WebSocket) web_ = std::make_unique<WebWire>(socket_, server);
}

TestClient::TestClient(TestClient&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)),
      web_(std::move(other.web_)),
      decoder_(std::move(other.decoder_)),
      received_(std::move(other.received_)),
      answer_pings_(other.answer_pings_),
      most_at_once_(other.most_at_once_),
      pause_(std::move(other.pause_)),
      pings_(other.pings_) {}

TestClient::~TestClient() {
  if (socket_ >= 0) ::close(socket_);
}

bool TestClient::send_bytes(std::string_view stream) {
  return web_ ? send_raw(on_the_wire(stream)) : send_raw(stream);
}

std::string TestClient::on_the_wire(std::string_view stream) {
  return web_ ? web_->frames_of(stream) : std::string(stream);
}

bool TestClient::send_raw(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    // Asio, below WebWire, has made the socket one that does not wait.
    if (sent < 0 && web_ && errno == EAGAIN && wait_for(POLLOUT, socket_)) continue;
    if (sent <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

bool TestClient::is_open() {
  std::array<char, 4096> buffer;
  ssize_t size = 0;
  while ((size = ::recv(socket_, buffer.data(), buffer.size(), 0)) > 0) {
  }
  return size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);  // nothing came for ten seconds
}

void TestClient::finish_sending() {
  ::shutdown(socket_, SHUT_WR);
}

std::size_t TestClient::receive_raw(std::size_t most, char* bytes) {
  std::string ignored(bytes ? 0 : most, '\0');
  if (web_) wait_for(POLLIN, socket_);
  const ssize_t size = ::recv(socket_, bytes ? bytes : ignored.data(), most, 0);
  if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
    throw std::runtime_error("nothing came for ten seconds");
  }
  return size > 0 ? static_cast<std::size_t>(size) : 0;
}

int TestClient::web_close_code() const {
  return web_ ? web_->close_code() : 0;
}

bool TestClient::fill_from_web() {
  const std::optional<std::string> message = web_->read();
  if (!message) return false;
  Envelope envelope;
  if (!envelope.ParseFromString(*message)) throw std::runtime_error("the server sent garbage");
  received_.push_back(std::move(envelope));
  return true;
}

bool TestClient::fill() {
  if (web_) return fill_from_web();
  std::array<std::byte, 64 * 1024> buffer;
  pause_();
  const ssize_t size = ::recv(socket_, buffer.data(), std::min(buffer.size(), most_at_once_), 0);
  if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
    throw std::runtime_error("nothing came for ten seconds");
  }
  if (size <= 0) return false;
  std::span<const std::byte> input(buffer.data(), static_cast<std::size_t>(size));
  for (;;) {
    const auto result = decoder_.next(input);
    if (std::holds_alternative<protocol::Decoder::NeedMore>(result)) return true;
    if (const auto* failure = std::get_if<protocol::Decoder::Failure>(&result)) {
      throw std::runtime_error("the server sent " + failure->what);
    }
    received_.push_back(std::get<Envelope>(result));
  }
}

std::optional<Envelope> TestClient::receive() {
  for (;;) {
    while (received_.empty()) {
      if (!fill()) return std::nullopt;
    }
    Envelope envelope = std::move(received_.front());
    received_.pop_front();
    if (!envelope.has_ping()) return envelope;
    ++pings_;
    if (answer_pings_) {
      Envelope pong;
      pong.mutable_pong()->set_nonce(envelope.ping().nonce());
      send(pong);
    }
  }
}

Envelope TestClient::expect(Envelope::BodyCase kind) {
  std::optional<Envelope> envelope = receive();
  if (!envelope) throw std::runtime_error("the server closed");
  if (envelope->body_case() != kind) {
    throw std::runtime_error("expected message " + std::to_string(kind) + ", got " +
                             std::to_string(envelope->body_case()) +
                             (envelope->has_error()
                                  ? ": " + protocol::Error::Code_Name(envelope->error().code()) +
                                        " " + envelope->error().text()
                                  : ""));
  }
  return std::move(*envelope);
}

protocol::Error TestClient::expect_error(protocol::Error::Code code) {
  protocol::Error error = expect(Envelope::kError).error();
  if (error.code() != code) {
    throw std::runtime_error("expected " + protocol::Error::Code_Name(code) + ", got " +
                             protocol::Error::Code_Name(error.code()) + ": " + error.text());
  }
  return error;
}

Envelope hello_message() {
  Envelope envelope;
  protocol::Hello& hello = *envelope.mutable_hello();
  hello.set_version(protocol::kProtocolVersion);
  protocol::Camera& camera = *hello.mutable_camera();
  camera.set_width(640);
  camera.set_height(480);
  camera.set_fx(600.0);
  camera.set_fy(600.0);
  camera.set_cx(319.5);
  camera.set_cy(239.5);
  return envelope;
}

Envelope frame_message(std::uint64_t id, std::string_view jpeg) {
  Envelope envelope;
  protocol::CameraFrame& frame = *envelope.mutable_camera_frame();
  frame.set_frame_id(id);
  frame.set_capture_time_us(id * 1000);
  frame.set_jpeg(std::string(jpeg));
  return envelope;
}

protocol::Envelope environment_message(std::string_view jpeg) {
  protocol::Envelope envelope;
  envelope.mutable_environment()->set_image(std::string(jpeg));
  return envelope;
}

void add_pose(Envelope& frame, int marker, double z) {
  protocol::Pose& pose = *frame.mutable_camera_frame()->add_poses();
  pose.set_marker(marker);
  pose.mutable_rotation()->set_x(1.0);
  pose.mutable_translation()->set_z(z);
}

std::string read_to_end(const common::HostPort& server) {
  return take_all(connect_to(server, 0));
}

HttpAnswer http_get(const common::HostPort& server, const std::string& path,
                    const std::string& method) {
  return http_exchange(server, method + " " + path + " HTTP/1.0\r\nHost: test\r\n\r\n");
}

HttpAnswer http_exchange(const common::HostPort& server, const std::string& request) {
  const int handle = connect_to(server, 0);
  ::send(handle, request.data(), request.size(), MSG_NOSIGNAL);
  const std::string text = take_all(handle);
  HttpAnswer answer;
  const std::size_t end = text.find("\r\n\r\n");
  if (end == std::string::npos) return answer;
  answer.head = text.substr(0, end);
  answer.body = text.substr(end + 4);
  answer.status = std::atoi(answer.head.c_str() + answer.head.find(' '));
  return answer;
}

}  // namespace amalgam::test
