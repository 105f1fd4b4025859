// The server's side of TLS 1.3.
#pragma once

#include <boost/asio/ssl/context.hpp>
#include <memory>

#include "net/server_config.h"

namespace amalgam::net {

using TlsContext = std::shared_ptr<boost::asio::ssl::context>;

// Connections that were made with a context keep it, so it can be replaced at any time. Null
// without files. Throws std::runtime_error, with one line, for files that cannot be used or do not
// belong together.
TlsContext make_tls_context(const TlsFiles& files);

}  // namespace amalgam::net
