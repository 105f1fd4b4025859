// What the fuzz targets share. A target reads bytes as the program would and checks what it then
// promises: mistakes in the bytes are told by the documented exception and by nothing else.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

// libFuzzer calls it with bytes that it makes up, corpus_test.cpp with the kept ones. Returns 0, or
// -1 for bytes that are not worth being varied.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace amalgam::fuzz {

inline std::span<const std::byte> as_bytes(const std::uint8_t* data, std::size_t size) {
  return std::as_bytes(std::span(data, size));
}

inline std::string as_text(const std::uint8_t* data, std::size_t size) {
  return {data, data + size};
}

}  // namespace amalgam::fuzz
