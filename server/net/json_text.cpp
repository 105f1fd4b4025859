#include "net/json_text.h"

#include <nlohmann/json.hpp>

namespace amalgam::net {

std::string json_string(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace amalgam::net
