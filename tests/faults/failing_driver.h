// Lets calls into OpenGL and Embree fail as if memory were missing.
#pragma once

#include <cstdint>

namespace amalgam::test {

// From now on calls of OpenGL that may need memory are counted. Call it once, when a frame has been
// rendered (before that libepoxy has not looked the functions up), and while none is.
void watch_opengl();
// The k-th counted call from now on, from 0: it does nothing, and glGetError() says out of memory.
// Negative: none.
void fail_opengl_call(std::int64_t k);
// As much for Embree's commits, which do nothing then.
void fail_embree_commit(std::int64_t k);
// One of Embree's allocations, of devices that were made in this program: its memory monitor
// refuses it. Placing instances needs none.
void fail_embree_allocation(std::int64_t k);
// How many were made to fail so far.
std::uint64_t failed_opengl_calls();
std::uint64_t failed_embree_commits();
std::uint64_t failed_embree_allocations();

}  // namespace amalgam::test
