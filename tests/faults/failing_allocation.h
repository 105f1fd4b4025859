// Lets the k-th allocation of a thread fail. Whoever links this replaces operator new.
#pragma once

#include <cstdint>

namespace amalgam::test {

// Only allocations of armed threads count and fail.
void arm_this_thread(bool armed);
// The allocation with this number, from 0 on, throws std::bad_alloc, once.
void fail_allocation(std::int64_t number);
void fail_no_allocation();
// So far.
std::uint64_t failed_allocations();

}  // namespace amalgam::test
