// libjpeg's coefficient interface, made safe for C++. For this folder only.
//
// libjpeg reports errors through a function that must not return. Throwing through C code is
// undefined, so that function jumps (longjmp) to the innermost guard(), which throws. The jump runs
// no destructors: code inside guard() must not own anything.
#pragma once

#include <cstdio>
// jpeglib.h uses FILE without including it.
#include <jpeglib.h>

#include <array>
#include <csetjmp>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "codec/jpeg.h"

namespace amalgam::codec {

// libjpeg's error handler. Warnings (damaged data) count as errors, but for stray bytes.
class LibjpegErrors {
 public:
  LibjpegErrors();
  LibjpegErrors(const LibjpegErrors&) = delete;
  LibjpegErrors& operator=(const LibjpegErrors&) = delete;

  jpeg_error_mgr* manager() { return &hooks_.manager; }

  // Runs work() and throws JpegError, "<what>: <libjpeg's words>", if libjpeg gives up inside.
  template <typename Work>
  void guard(const char* what, const Work& work) {
    if (setjmp(hooks_.jump) != 0) fail(what);
    work();
  }

 private:
  struct Hooks {
    jpeg_error_mgr manager;  // first: libjpeg knows only this part
    std::jmp_buf jump;
    std::array<char, JMSG_LENGTH_MAX> text;
  };

  static void give_up(j_common_ptr info);
  static void judge(j_common_ptr info, int level);
  [[noreturn]] void fail(const char* what) const;

  Hooks hooks_{};
};

// A JPEG's quantised DCT coefficients in memory: Huffman-decoded, nothing else. Does not refer to
// the bytes once it is constructed.
class CoefficientReader {
 public:
  // Reads to the end. jpeg: has passed read_jpeg_header(). Throws JpegError, at the first warning
  // too, as decode_jpeg() does.
  explicit CoefficientReader(std::span<const std::byte> jpeg);
  ~CoefficientReader();
  CoefficientReader(const CoefficientReader&) = delete;
  CoefficientReader& operator=(const CoefficientReader&) = delete;

  jpeg_decompress_struct& info() { return info_; }
  jvirt_barray_ptr* arrays() { return arrays_; }
  LibjpegErrors& errors() { return errors_; }

  std::span<const jpeg_component_info> components() const {
    return {info_.comp_info, static_cast<std::size_t>(info_.num_components)};
  }

 private:
  LibjpegErrors errors_;
  jpeg_decompress_struct info_{};
  jvirt_barray_ptr* arrays_ = nullptr;
};

// Rows of blocks of one component, at most v_samp_factor of them, padded to whole MCUs. Errors go
// to user, which need not have made the array: call this inside user's guard(). Without writable,
// several threads may read an array that has been written completely.
JBLOCKARRAY block_rows(jpeg_decompress_struct& user, jvirt_barray_ptr array, int first, int count,
                       bool writable);

// A compressor that writes into memory.
class MemoryCompressor {
 public:
  // expected: estimated bytes of the result; only a hint.
  explicit MemoryCompressor(std::size_t expected);
  ~MemoryCompressor();
  MemoryCompressor(const MemoryCompressor&) = delete;
  MemoryCompressor& operator=(const MemoryCompressor&) = delete;

  jpeg_compress_struct& info() { return info_; }
  LibjpegErrors& errors() { return errors_; }

  // The finished file (after jpeg_finish_compress).
  std::vector<std::byte> take();

 private:
  struct Destination {
    jpeg_destination_mgr manager;  // first: libjpeg knows only this part
    std::vector<std::byte>* bytes;
  };

  static void begin(j_compress_ptr info);
  static boolean grow(j_compress_ptr info);

  std::vector<std::byte> bytes_;
  LibjpegErrors errors_;
  Destination destination_{};
  jpeg_compress_struct info_{};
};

}  // namespace amalgam::codec
