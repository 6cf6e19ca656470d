/// \file
/// Whether this build is slow, so that the largest cases are cut.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>

namespace soms::test {

/// True in debug and sanitizer builds (SOMS_ASSERTIONS in cmake/options.cmake).
#if SOMS_ASSERTIONS
inline constexpr bool kSlowBuild = true;
#else
inline constexpr bool kSlowBuild = false;
#endif

/// So many random cases, or a quarter of them in a slow build.
constexpr int some_of(int count) {
  return kSlowBuild ? (count + 3) / 4 : count;
}

/// Of a table of rows with columns, those that are tried: all, but in a slow build one column of
/// each row, another one in the next.
constexpr bool is_tried(std::size_t row, std::size_t column, std::size_t columns) {
  return !kSlowBuild || row % columns == column;
}

}  // namespace soms::test

/// Ends a test that takes long under a sanitizer and shows it nothing that others do not.
#define SOMS_SKIP_IN_SLOW_BUILDS()                                                 \
  do {                                                                             \
    if (soms::test::kSlowBuild) {                                                  \
      GTEST_SKIP() << "takes long in this build: the release suite alone runs it"; \
    }                                                                              \
  } while (false)
