// Every limit of the protocol and of a session. These are defaults; server/net/server_config.h has
// those that an operator may change.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace amalgam::protocol {

inline constexpr std::uint32_t kProtocolVersion = 1;
inline constexpr std::size_t kLengthBytes = 4;  // the length before each Envelope

// --- sizes, of one Envelope --- The most that an unauthenticated client can make the server hold:
// a Hello with the longest token is below 2 KiB.
inline constexpr std::size_t kMaxBeforeHelloBytes = 4 * 1024;
// Everything but images: 64 poses are below 8 KiB, the rest is room to grow.
inline constexpr std::size_t kMaxControlBytes = 64 * 1024;
// A camera frame of 4 Mpixel at a good quality is 1 to 2 MiB.
inline constexpr std::size_t kMaxCameraFrameBytes = 4 * 1024 * 1024;
// Checked by clients only: 4 Mpixel at quality 100 without subsampling are smaller.
inline constexpr std::size_t kMaxCompositeBytes = 32 * 1024 * 1024;
// Long enough for any generated secret, and keeps a Hello below kMaxBeforeHelloBytes.
inline constexpr std::size_t kMaxTokenBytes = 1024;

// --- contents ---
inline constexpr std::uint32_t kMaxSide = 2048;               // pixels: the largest render target
inline constexpr std::uint64_t kMaxPixels = 4 * 1024 * 1024;  // the same, as an area
inline constexpr int kMaxPoses = 64;  // more markers than fit a desk at a readable size
// Corners of one marker that are looked at in a frame: solving a pose takes some 70 us of the
// thread that all clients share.
inline constexpr int kMaxSameMarker = 2;
inline constexpr double kMaxSmoothing = 1e6;  // cut-off in Hz and beta of Hello.smoothing
inline constexpr int kMaxDistortion = 12;     // coefficients of OpenCV's rational thin-prism model
inline constexpr std::uint32_t kMaxJpegQuality = 100;

// --- times ---
// A hello is a few hundred bytes: 2 s are three retransmissions on a bad link.
inline constexpr std::chrono::milliseconds kHelloTimeout{2000};
// A frame that takes longer is of no use to a viewer.
inline constexpr std::chrono::milliseconds kMessageTimeout{5000};
// Below this no camera stream is watchable. Ends senders of one byte at a time ...
inline constexpr std::size_t kMinBytesPerSecond = 64 * 1024;
// ... but a radio link may fall silent for this long before the rate is judged.
inline constexpr std::chrono::milliseconds kRateGrace{2000};
inline constexpr std::chrono::milliseconds kPingInterval{1000};
// Five pings lost in a row: the peer is gone. Also TCP_USER_TIMEOUT.
inline constexpr std::chrono::milliseconds kIdleTimeout{5000};
// A reader that takes no composite for this long is evicted.
inline constexpr std::chrono::milliseconds kWriteTimeout{5000};
// After the last message both sides may read to the end; then the socket is closed regardless.
inline constexpr std::chrono::milliseconds kLinger{1000};
// An older held pose would visibly drift.
inline constexpr std::chrono::milliseconds kPoseHold{250};
// A capture time may lead its predecessor by the time between arrivals plus this.
inline constexpr std::chrono::milliseconds kMaxCaptureLead{10000};
// Supervisors kill after 25 to 30 s; this leaves time for a clean end.
inline constexpr std::chrono::milliseconds kDrainTimeout{20000};
inline constexpr std::chrono::milliseconds kRetryAfter{2000};
// A tile takes milliseconds, a pass a second at most: a renderer that shows no progress for longer
// is stuck. Leaves a second of the five that supervisors are promised.
inline constexpr std::chrono::milliseconds kStuckAfter{4000};
// Making a renderer shows no progress: shaders and trees of a large scene take some ten seconds on
// a slow machine.
inline constexpr std::chrono::milliseconds kStuckReloadAfter{60'000};
// Half-sent requests of the admin port. Monitoring systems send theirs in one packet.
inline constexpr std::chrono::milliseconds kAdminTimeout{2000};

// --- rates ---
// Light changes slowly, and each change costs all clients the extraction of lights.
inline constexpr double kEnvironmentsPerSecond = 1.0;
inline constexpr double kEnvironmentBurst = 2.0;

// --- admission ---
// Part of the renderer's time that sessions may need together. The rest is for frames that cost
// more than the last ones did.
inline constexpr double kMaxLoad = 0.85;
inline constexpr std::uint64_t kMaxSessionMemory = std::uint64_t{8} * 1024 * 1024 * 1024;

// --- counts ---
inline constexpr std::size_t kMaxConnections = 256;
inline constexpr std::size_t kMaxUnauthenticated = 64;
inline constexpr std::size_t kMaxPerAddress = 16;
inline constexpr std::size_t kMaxAdminConnections = 16;
// Waiting answers to a peer that does not read; further ones are dropped.
inline constexpr std::size_t kMaxQueuedControl = 32;

// --- records of sessions, if the operator wants them ---
inline constexpr std::uint64_t kMiB = 1024 * 1024;
// Some minutes of 640 x 480 at 30 Hz, and what can be attached to a report.
inline constexpr std::uint64_t kMaxSessionRecordBytes = 256 * kMiB;
inline constexpr std::uint64_t kMaxRecordBytes = 4096 * kMiB;  // of all sessions
// What waits for the disk. The largest composite fits in, and seconds of usual ones.
inline constexpr std::size_t kMaxRecordQueueBytes = 64 * kMiB;

// --- buffers ---
inline constexpr std::size_t kReadBufferBytes = 64 * 1024;  // after the hello; before: 4 KiB
// Unsent bytes that the kernel may buffer. More would be old frames that newest-wins cannot
// replace.
inline constexpr int kUnsentBytes = 64 * 1024;
// Between two times that freed memory goes back to the system: within the five seconds promised.
inline constexpr std::chrono::milliseconds kTrimInterval{3500};
// SO_SNDBUF: what is on its way or unread. Left to itself the kernel takes megabytes, which a
// reader that stops would find full of old frames.
inline constexpr int kSendBufferBytes = 256 * 1024;
// Composites that may be on their way or unread. A Ping follows each, so that its Pong tells when
// it was read. One, where the second would only wait behind it (net/read_pings.h).
inline constexpr std::size_t kMaxUnreadComposites = 2;

}  // namespace amalgam::protocol
