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

}  // namespace soms::test
