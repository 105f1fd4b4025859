// A blocking client for tests: sends any bytes, good or bad, and waits for what comes back, never
// for longer than ten seconds.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "net/server_config.h"
#include "protocol/framing.h"

namespace amalgam::test {

class WebWire;

enum class Over { Tcp, WebSocket };

class TestClient {
 public:
  // receive_buffer: SO_RCVBUF in bytes; 0 leaves it to the kernel. first: bytes before all others.
  // Over WebSocket, throws std::runtime_error if the server does not want it.
  explicit TestClient(const common::HostPort& server, int receive_buffer = 0, Over over = Over::Tcp,
                      const std::string& first = "");
  TestClient(TestClient&& other) noexcept;
  TestClient& operator=(TestClient&&) = delete;
  ~TestClient();

  // What send_bytes() sends for this stream, and sending just that: for who measures memory
  // meanwhile.
  std::string on_the_wire(std::string_view stream);
  bool send_raw(std::string_view bytes);

  // False if the server has closed.
  bool send(const protocol::Envelope& envelope) { return send_bytes(protocol::encode(envelope)); }
  // Of a stream of Envelopes with lengths, which becomes WebSocket's frames where due.
  bool send_bytes(std::string_view stream);
  // Exactly these.
  void finish_sending();

  // The next message that is not a Ping (those are answered, unless told not to); nothing at the
  // end of the connection. Throws std::runtime_error after ten seconds.
  std::optional<protocol::Envelope> receive();
  // The next message, which must be of this kind; std::runtime_error otherwise.
  protocol::Envelope expect(protocol::Envelope::BodyCase kind);
  // The next message must be this Error. Returns it.
  protocol::Error expect_error(protocol::Error::Code code);
  // True if the server closes without saying anything more.
  bool closed_by_server() { return !receive().has_value(); }

  // What comes next as bytes, instead of receive(): their number, 0 at the end.
  std::size_t receive_raw(std::size_t most, char* bytes = nullptr);
  int handle() const { return socket_; }
  // With which the server closed a WebSocket; 0: it did not.
  int web_close_code() const;

  // Reads and forgets to the end of the connection. False when that is reached.
  bool is_open();
  void answer_pings(bool answer) { answer_pings_ = answer; }
  // From here on takes at most so many bytes at a time, and calls pause before each.
  void read_slowly(std::size_t bytes, std::function<void()> pause) {
    most_at_once_ = bytes;
    pause_ = std::move(pause);
  }
  std::size_t pings() const { return pings_; }

 private:
  bool fill();
  bool fill_from_web();

  int socket_ = -1;
  std::unique_ptr<WebWire> web_;
  protocol::Decoder decoder_{protocol::limits_of_client()};
  std::deque<protocol::Envelope> received_;
  bool answer_pings_ = true;
  std::size_t most_at_once_ = 64 * 1024;
  std::function<void()> pause_ = [] {};
  std::size_t pings_ = 0;
};

protocol::Envelope hello_message();  // a camera of 640 x 480, no token
protocol::Envelope frame_message(std::uint64_t id, std::string_view jpeg = "jpeg");
protocol::Envelope environment_message(std::string_view jpeg);  // equirectangular
void add_pose(protocol::Envelope& frame, int marker, double z = 0.5);

// What a server says to whoever says nothing.
std::string read_to_end(const common::HostPort& server);

// The text of an HTTP answer and its status.
struct HttpAnswer {
  int status = 0;
  std::string head, body;
};
HttpAnswer http_exchange(const common::HostPort& server, const std::string& request);
HttpAnswer http_get(const common::HostPort& server, const std::string& path,
                    const std::string& method = "GET");

}  // namespace amalgam::test
