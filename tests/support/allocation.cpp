#include "tests/support/allocation.h"

#include <malloc.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

std::atomic<std::uint64_t> allocations = 0;
std::atomic<std::uint64_t> bytes_now = 0;
std::atomic<std::uint64_t> bytes_peak = 0;

/// Counts what malloc gave, be it nothing.
void* counted(void* memory) noexcept {
  if (memory != nullptr) {
    ++allocations;
    const std::uint64_t now = bytes_now += malloc_usable_size(memory);
    std::uint64_t peak = bytes_peak;
    while (now > peak && !bytes_peak.compare_exchange_weak(peak, now)) {
    }
  }
  return memory;
}

void* allocate(std::size_t size) noexcept {
  return counted(std::malloc(size == 0 ? 1 : size));
}

void* allocate(std::size_t size, std::align_val_t alignment) noexcept {
  const auto unit = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(unit, (size + unit - 1) / unit * unit));
}

void release(void* memory) noexcept {
  if (memory != nullptr) {
    bytes_now -= malloc_usable_size(memory);
    std::free(memory);
  }
}

/// Allocations of this thread that are still to succeed.
thread_local std::uint64_t lasting_now = std::numeric_limits<std::uint64_t>::max();

void* or_throw(void* memory) {
  if (memory == nullptr || lasting_now == 0) {
    release(memory);
    throw std::bad_alloc();
  }
  --lasting_now;
  return memory;
}

}  // namespace

// All forms: a sanitizer replaces each form that is left out by its own, whose memory must not come
// to ours. std::stable_sort takes nothrow memory and gives it back to plain delete.

void* operator new(std::size_t size) {
  return or_throw(allocate(size));
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size);
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  return or_throw(allocate(size, alignment));
}

void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate(size, alignment);
}

void* operator new[](std::size_t size) {
  return or_throw(allocate(size));
}

void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size);
}

void* operator new[](std::size_t size, std::align_val_t alignment) {
  return or_throw(allocate(size, alignment));
}

void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate(size, alignment);
}

void operator delete(void* memory) noexcept {
  release(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}

void operator delete(void* memory, const std::nothrow_t&) noexcept {
  release(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept {
  release(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  release(memory);
}

void operator delete(void* memory, std::align_val_t, const std::nothrow_t&) noexcept {
  release(memory);
}

void operator delete[](void* memory) noexcept {
  release(memory);
}

void operator delete[](void* memory, std::size_t) noexcept {
  release(memory);
}

void operator delete[](void* memory, const std::nothrow_t&) noexcept {
  release(memory);
}

void operator delete[](void* memory, std::align_val_t) noexcept {
  release(memory);
}

void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
  release(memory);
}

void operator delete[](void* memory, std::align_val_t, const std::nothrow_t&) noexcept {
  release(memory);
}

namespace soms::test {

AllocationWatch::AllocationWatch() : bytes_before_(bytes_now), count_before_(allocations) {
  bytes_peak = bytes_before_;
}

std::uint64_t AllocationWatch::count() const {
  return allocations - count_before_;
}

std::uint64_t AllocationWatch::peak() const {
  return bytes_peak - bytes_before_;
}

AllocationFault::AllocationFault(std::uint64_t lasting) {
  lasting_now = lasting;
}

AllocationFault::~AllocationFault() {
  lasting_now = std::numeric_limits<std::uint64_t>::max();
}

}  // namespace soms::test
