#include "net/tls.h"

#include <openssl/ssl.h>

#include <stdexcept>
#include <string>

namespace amalgam::net {

TlsContext make_tls_context(const TlsFiles& files) {
  namespace ssl = boost::asio::ssl;
  if (files.certificate.empty() && files.key.empty()) return nullptr;
  if (files.certificate.empty() || files.key.empty()) {
    throw std::runtime_error("TLS needs a certificate and a key");
  }
  auto context = std::make_shared<ssl::context>(ssl::context::tls_server);
  SSL_CTX_set_min_proto_version(context->native_handle(), TLS1_3_VERSION);
  boost::system::error_code ec;
  context->use_certificate_chain_file(files.certificate, ec);
  if (ec) {
    throw std::runtime_error("the certificate " + files.certificate +
                             " cannot be used: " + ec.message());
  }
  context->use_private_key_file(files.key, ssl::context::pem, ec);
  if (ec) throw std::runtime_error("the key " + files.key + " cannot be used: " + ec.message());
  if (SSL_CTX_check_private_key(context->native_handle()) != 1) {
    throw std::runtime_error("the key " + files.key + " is not that of " + files.certificate);
  }
  return context;
}

}  // namespace amalgam::net
