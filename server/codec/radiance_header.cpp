#include "codec/radiance_header.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "codec/picture.h"

namespace amalgam::codec {
namespace {

std::string_view trim(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

// The next word, which is taken off the text; empty at its end.
std::string_view take_word(std::string_view& text) {
  text = trim(text);
  const std::string_view word = text.substr(0, text.find_first_of(" \t"));
  text.remove_prefix(word.size());
  return word;
}

template <std::size_t N>
std::array<double, N> numbers(std::string_view name, std::string_view text) {
  std::array<double, N> all{};
  for (double& number : all) {
    std::string_view word = take_word(text);
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(number)) {
      throw PictureError("damaged picture: " + std::string(name) + " is not " + std::to_string(N) +
                         (N == 1 ? " number" : " numbers"));
    }
  }
  return all;
}

glm::dvec3 positive(std::string_view name, const glm::dvec3& factors) {
  for (int i = 0; i < 3; ++i) {
    if (!(factors[i] > 0.0)) {
      throw PictureError("damaged picture: " + std::string(name) + " is not positive");
    }
  }
  return factors;
}

// A line that begins with a blank quotes the header of another picture, and does not count.
void read_line(std::string_view line, RadianceHeader& header) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return;
  const std::string_view name = line.substr(0, equals), value = trim(line.substr(equals + 1));
  if (name == "FORMAT") {
    header.is_xyz = value == "32-bit_rle_xyze";
    if (!header.is_xyz && value != "32-bit_rle_rgbe") {
      throw PictureError("its FORMAT is '" + std::string(value.substr(0, 40)) +
                         "', neither 32-bit_rle_rgbe nor 32-bit_rle_xyze");
    }
  } else if (name == "EXPOSURE") {
    header.exposure *= positive(name, glm::dvec3(numbers<1>(name, value)[0]));
  } else if (name == "COLORCORR") {
    const auto factors = numbers<3>(name, value);
    header.exposure *= positive(name, glm::dvec3(factors[0], factors[1], factors[2]));
  } else if (name == "PRIMARIES") {
    const auto xy = numbers<8>(name, value);
    header.primaries =
        Chromaticities{{xy[0], xy[1]}, {xy[2], xy[3]}, {xy[4], xy[5]}, {xy[6], xy[7]}};
  }
}

int length(std::string_view word) {
  int number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size() || number < 1) {
    throw PictureError("damaged picture: no size");
  }
  return number;
}

// "-Y 32 +X 64": 32 lines from top to bottom of 64 pixels from left to right.
void read_size(std::string_view line, RadianceHeader& header) {
  std::array<std::string_view, 2> axes;
  std::array<int, 2> lengths{};
  for (std::size_t i = 0; i < 2; ++i) {
    axes[i] = take_word(line);
    lengths[i] = length(take_word(line));
    if (axes[i] == "-X") header.right_to_left = true;
    if (axes[i] == "+Y") header.bottom_up = true;
  }
  header.by_columns = axes[0].ends_with('X');
  const std::size_t x = header.by_columns ? 0 : 1;
  if ((axes[x] != "+X" && axes[x] != "-X") || (axes[1 - x] != "+Y" && axes[1 - x] != "-Y")) {
    throw PictureError("damaged picture: no size");
  }
  header.size = {lengths[x], lengths[1 - x]};
}

}  // namespace

RadianceHeader read_radiance_header(std::string_view file) {
  if (!file.starts_with("#?")) throw PictureError("not a Radiance picture");
  RadianceHeader header;
  bool size_is_next = false;
  for (std::size_t at = 0;;) {
    const std::size_t end = file.find('\n', at);
    if (end == std::string_view::npos) throw PictureError("damaged picture: truncated");
    const std::string_view line = file.substr(at, end - at);
    at = end + 1;
    if (size_is_next) {
      read_size(line, header);
      header.pixels_at = at;
      return header;
    }
    read_line(line, header);
    size_is_next = trim(line).empty();
  }
}

}  // namespace amalgam::codec
