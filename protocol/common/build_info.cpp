#include "common/build_info.h"

#include <elf.h>
#include <link.h>

#include <cstddef>

#include "common/hex_text.h"

namespace amalgam::common {
namespace {

std::size_t padded(std::size_t size) {
  return (size + 3) / 4 * 4;
}

// The GNU build id among a segment's notes; empty if there is none.
std::string build_id_among(const unsigned char* notes, std::size_t size) {
  while (size > sizeof(ElfW(Nhdr))) {
    const auto* const note = reinterpret_cast<const ElfW(Nhdr)*>(notes);
    const std::size_t name = padded(note->n_namesz),
                      whole = sizeof *note + name + padded(note->n_descsz);
    if (whole > size) break;
    if (note->n_type == NT_GNU_BUILD_ID)
      return hex_text({notes + sizeof *note + name, note->n_descsz});
    notes += whole;
    size -= whole;
  }
  return "";
}

// Called for the program first, and for no library.
int find_build_id(dl_phdr_info* info, std::size_t, void* found) {
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const auto& segment = info->dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    const auto* const notes =
        reinterpret_cast<const unsigned char*>(info->dlpi_addr + segment.p_vaddr);
    auto& text = *static_cast<std::string*>(found);
    if (text.empty()) text = build_id_among(notes, segment.p_memsz);
  }
  constexpr int kStop = 1;
  return kStop;
}

}  // namespace

const char* version() {
  return AMALGAM_VERSION;
}

const char* instruction_set() {
#if !defined(__x86_64__)
  return "other";
#elif defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512VL__)
  return "x86-64-v4";
#elif defined(__AVX2__) && defined(__FMA__)
  return "x86-64-v3";
#elif defined(__SSE4_2__)
  return "x86-64-v2";
#else
  return "x86-64";
#endif
}

std::string build_id() {
  std::string text;
  dl_iterate_phdr(&find_build_id, &text);
  return text;
}

std::string version_line(const std::string& program) {
  return program + " " + version() + ", compiled for " + instruction_set();
}

}  // namespace amalgam::common
