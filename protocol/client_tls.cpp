#include "protocol/client_tls.h"

#include <memory>
#include <stdexcept>

namespace amalgam::protocol {

Stream::Tls client_tls(const std::string& certificate_authority) {
  namespace ssl = boost::asio::ssl;
  auto tls = std::make_shared<ssl::context>(ssl::context::tls_client);
  SSL_CTX_set_min_proto_version(tls->native_handle(), TLS1_3_VERSION);
  boost::system::error_code ec;
  certificate_authority.empty() ? tls->set_default_verify_paths(ec)
                                : tls->load_verify_file(certificate_authority, ec);
  if (ec) {
    throw std::runtime_error("the certificates in " + certificate_authority +
                             " cannot be used: " + ec.message());
  }
  return tls;
}

}  // namespace amalgam::protocol
