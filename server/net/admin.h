// The admin port: an HTTP server for operators and their monitoring (admin_pages.h says with what).
// Runs on the network thread, so that an answer proves that this thread is alive. When all places
// are taken, the oldest connection makes room for a new one, so that slow ones lock nobody out.
#pragma once

#include <boost/asio/io_context.hpp>
#include <cstddef>
#include <list>
#include <memory>

#include "net/accept_loop.h"
#include "net/admin_pages.h"
#include "net/server_config.h"

namespace amalgam::net {

class Admin {
 public:
  Admin(boost::asio::io_context& io, const common::HostPort& address, std::size_t max_connections,
        AdminPages pages);

  void start();
  void restart() { accept_loop_.restart(); }
  void close() { accept_loop_.close(); }
  void set_max_connections(std::size_t most) { max_connections_ = most; }
  common::HostPort address() const { return accept_loop_.address(); }

 private:
  class Connection;
  void accept(boost::asio::ip::tcp::socket socket);
  // Kept alive by connections, whose last handlers may run after the Admin's end.
  struct Shared {
    AdminPages pages;
    std::list<Connection*> connections;  // the oldest first
  };
  std::shared_ptr<Shared> shared_;
  std::size_t max_connections_;
  AcceptLoop accept_loop_;
};

}  // namespace amalgam::net
