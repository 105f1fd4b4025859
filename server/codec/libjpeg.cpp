#include "codec/libjpeg.h"

#include <jerror.h>

#include <new>

namespace amalgam::codec {
namespace {

// Webcams pad their data before a marker with some bytes, and everybody shows the picture. More of
// them mean that the data before were not understood.
constexpr int kMaxStrayBytes = 64;

// Doubles the buffer. Exceptions must not pass through libjpeg.
bool doubled(std::vector<std::byte>& bytes) noexcept {
  try {
    bytes.resize(2 * bytes.size());
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void hand_out(jpeg_destination_mgr& manager, std::vector<std::byte>& bytes, std::size_t from) {
  manager.next_output_byte = reinterpret_cast<JOCTET*>(bytes.data() + from);
  manager.free_in_buffer = bytes.size() - from;
}

}  // namespace

LibjpegErrors::LibjpegErrors() {
  jpeg_std_error(&hooks_.manager);
  hooks_.manager.error_exit = give_up;
  hooks_.manager.emit_message = judge;
  hooks_.manager.output_message = [](j_common_ptr) {};  // nothing goes to stderr
}

void LibjpegErrors::give_up(j_common_ptr info) {
  auto* hooks = reinterpret_cast<Hooks*>(info->err);
  info->err->format_message(info, hooks->text.data());
  std::longjmp(hooks->jump, 1);
}

void LibjpegErrors::judge(j_common_ptr info, int level) {
  if (level >= 0) return;
  const jpeg_error_mgr& error = *info->err;
  if (error.msg_code == JWRN_EXTRANEOUS_DATA && error.msg_parm.i[0] <= kMaxStrayBytes) return;
  give_up(info);  // a warning: the data are damaged
}

void LibjpegErrors::fail(const char* what) const {
  throw JpegError(std::string(what) + ": " + hooks_.text.data());
}

CoefficientReader::CoefficientReader(std::span<const std::byte> jpeg) {
  info_.err = errors_.manager();
  try {
    errors_.guard("damaged JPEG", [&] {
      jpeg_create_decompress(&info_);
      jpeg_mem_src(&info_, reinterpret_cast<const unsigned char*>(jpeg.data()),
                   static_cast<unsigned long>(jpeg.size()));
      jpeg_read_header(&info_, TRUE);
      arrays_ = jpeg_read_coefficients(&info_);
    });
  } catch (...) {
    jpeg_destroy_decompress(&info_);
    throw;
  }
}

CoefficientReader::~CoefficientReader() {
  jpeg_destroy_decompress(&info_);
}

JBLOCKARRAY block_rows(jpeg_decompress_struct& user, jvirt_barray_ptr array, int first, int count,
                       bool writable) {
  return user.mem->access_virt_barray(reinterpret_cast<j_common_ptr>(&user), array,
                                      static_cast<JDIMENSION>(first),
                                      static_cast<JDIMENSION>(count), writable ? TRUE : FALSE);
}

MemoryCompressor::MemoryCompressor(std::size_t expected) : bytes_(expected + 4096) {
  destination_.manager.init_destination = begin;
  destination_.manager.empty_output_buffer = grow;
  destination_.manager.term_destination = [](j_compress_ptr) {};
  destination_.bytes = &bytes_;
  info_.err = errors_.manager();
  errors_.guard("cannot make a JPEG encoder", [&] { jpeg_create_compress(&info_); });
  info_.dest = &destination_.manager;
}

MemoryCompressor::~MemoryCompressor() {
  jpeg_destroy_compress(&info_);
}

std::vector<std::byte> MemoryCompressor::take() {
  bytes_.resize(bytes_.size() - destination_.manager.free_in_buffer);
  return std::move(bytes_);
}

void MemoryCompressor::begin(j_compress_ptr info) {
  auto* destination = reinterpret_cast<Destination*>(info->dest);
  hand_out(destination->manager, *destination->bytes, 0);
}

// libjpeg calls this when the buffer is full, and expects all of it to be taken.
boolean MemoryCompressor::grow(j_compress_ptr info) {
  auto* destination = reinterpret_cast<Destination*>(info->dest);
  const std::size_t full = destination->bytes->size();
  if (!doubled(*destination->bytes)) ERREXIT1(info, JERR_OUT_OF_MEMORY, 0);
  hand_out(destination->manager, *destination->bytes, full);
  return TRUE;
}

}  // namespace amalgam::codec
