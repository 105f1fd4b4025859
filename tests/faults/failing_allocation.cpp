#include "faults/failing_allocation.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::int64_t> fail_at = -1;  // allocations of the armed thread until one fails
std::atomic<std::uint64_t> failed = 0;
thread_local bool armed = false;

void* allocate(std::size_t size) {
  if (armed && fail_at.load() >= 0 && fail_at.fetch_sub(1) == 0) {
    ++failed;
    throw std::bad_alloc();
  }
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new[](std::size_t size) {
  return allocate(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace amalgam::test {

void arm_this_thread(bool value) {
  armed = value;
}
void fail_allocation(std::int64_t number) {
  fail_at = number;
}
void fail_no_allocation() {
  fail_at = -1;
}
std::uint64_t failed_allocations() {
  return failed;
}

}  // namespace amalgam::test
