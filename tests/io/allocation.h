/// \file
/// How much memory this program has allocated at once.
#pragma once

#include <cstdint>

namespace soms::test {

/// Watches operator new from its construction on.
class AllocationWatch {
 public:
  AllocationWatch();

  /// Most bytes that were allocated at once, beyond those at the construction.
  [[nodiscard]] std::uint64_t peak() const;

 private:
  std::uint64_t before_ = 0;
};

}  // namespace soms::test
