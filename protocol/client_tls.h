// What clients of a server that encrypts need: whom they trust.
#pragma once

#include <string>

#include "protocol/stream.h"

namespace amalgam::protocol {

// TLS 1.3. certificate_authority: a file of certificates (PEM); empty: the system's. Throws
// std::runtime_error if it cannot be used.
Stream::Tls client_tls(const std::string& certificate_authority);

}  // namespace amalgam::protocol
