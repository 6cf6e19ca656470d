/// \file
/// What this program allocates. A test program that lists allocation.cpp among its sources replaces
/// operator new and delete.
#pragma once

#include <cstdint>

namespace soms::test {

/// Watches operator new from its construction on.
class AllocationWatch {
 public:
  AllocationWatch();

  /// Number of allocations since the construction.
  [[nodiscard]] std::uint64_t count() const;

  /// Most bytes that were allocated at once, beyond those at the construction.
  [[nodiscard]] std::uint64_t peak() const;

 private:
  std::uint64_t bytes_before_ = 0;
  std::uint64_t count_before_ = 0;
};

/// While it lives, operator new of this thread gives memory `lasting` times and throws from then
/// on.
class AllocationFault {
 public:
  explicit AllocationFault(std::uint64_t lasting);
  ~AllocationFault();
  AllocationFault(const AllocationFault&) = delete;
  AllocationFault& operator=(const AllocationFault&) = delete;
};

}  // namespace soms::test
