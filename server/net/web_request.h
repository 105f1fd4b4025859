// What a browser asks the web port for: the files of the page, files that are made for it, or a
// session (RFC 6455). Decides; knows no sockets.
#pragma once

#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <chrono>
#include <string>
#include <variant>
#include <vector>

#include "net/made_files.h"
#include "net/server_config.h"
#include "net/web_answer.h"

namespace amalgam::net {

using WebRequest = boost::beast::http::request<boost::beast::http::empty_body>;

// Where sessions are, on the web port.
inline constexpr std::string_view kSessionPath = "/session";

struct Upgrade {};

// One of WebOptions::made, which may take a while.
struct MadeFile {
  std::string target;
};

std::variant<Upgrade, WebAnswer, MadeFile> judge(const WebRequest& request,
                                                 const WebOptions& options);

// When that file is there, or cannot be.
WebAnswer answer_with(const WebRequest& request, const MadeFiles::Result& made);

// For what is no request at all. defect: a line for people.
WebAnswer answer_to_garbage(bool too_long, const std::string& defect);
// For connections that are refused before they have asked for anything.
std::string busy_answer(std::chrono::milliseconds retry_after, const std::string& reason);

// Whether a page from there may open sessions. Browsers send Origin, and other programs do not:
// without this check any page that somebody looks at could talk to a server on his own machine.
bool is_welcome(const WebRequest& request, const std::vector<std::string>& origins);

}  // namespace amalgam::net
