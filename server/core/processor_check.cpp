// Ends the program with one line if it was compiled for another processor than this one. Otherwise
// it would die of an illegal instruction. Linked into each program of a build with AMALGAM_ARCH,
// but compiled without it.
#include <errno.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

namespace {

void say(const char* text) {
  if (write(STDERR_FILENO, text, std::strlen(text)) < 0) return;  // nobody to be told
}

// Before the constructors of C++'s own static objects, which are compiled for that processor.
__attribute__((constructor(101))) void check_processor() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports(AMALGAM_ARCH)) return;
  say(program_invocation_short_name);
  say(": compiled for " AMALGAM_ARCH ", which this processor is not; build without AMALGAM_ARCH\n");
  _exit(EXIT_FAILURE);
}

}  // namespace
