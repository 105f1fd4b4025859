#include "common/image_size.h"

#include <charconv>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace amalgam::common {
namespace {

std::optional<int> parse_side(std::string_view text, int max_side) {
  int side = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (side < 1 || side > max_side) return std::nullopt;
  return side;
}

}  // namespace

glm::ivec2 parse_image_size(const std::string& text, int max_side) {
  const std::size_t x = text.find('x');
  const auto width = parse_side(std::string_view(text).substr(0, x), max_side);
  const auto height = x == std::string::npos
                          ? std::nullopt
                          : parse_side(std::string_view(text).substr(x + 1), max_side);
  if (!width || !height) {
    throw std::runtime_error("'" + text + "' is not WxH with sides of 1 to " +
                             std::to_string(max_side) + " pixels");
  }
  return {*width, *height};
}

}  // namespace amalgam::common
