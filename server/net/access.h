// Who may do what: tokens and the rights that come with them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace amalgam::net {

struct Rights {
  bool view = false;         // open a session and send frames
  bool environment = false;  // change the scene's light for everybody
  bool operator==(const Rights&) const = default;
};

struct Grant {
  std::string token;  // a secret: never logged
  Rights rights;
};

enum class EnvironmentFrom { None, Authorised, Any };

// A file with a line for each token: the token, then `view` and `environment` or none of them for
// all rights. Throws std::runtime_error, never quoting a token.
std::vector<Grant> read_grants(const std::string& path);

// The rights of a given token; nothing if it is none of the grants'. The time taken reveals nothing
// about them. Without grants everybody has all rights.
std::optional<Rights> rights_of(std::string_view given, const std::vector<Grant>& grants);

}  // namespace amalgam::net
