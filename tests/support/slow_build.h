/// \file
/// Whether this build is slow, so that the largest cases are cut.
#pragma once

#include <gtest/gtest.h>

namespace soms::test {

/// True in debug and sanitizer builds (SOMS_ASSERTIONS in cmake/options.cmake).
#if SOMS_ASSERTIONS
inline constexpr bool kSlowBuild = true;
#else
inline constexpr bool kSlowBuild = false;
#endif

}  // namespace soms::test

/// Ends a test that takes long under a sanitizer and shows it nothing that others do not.
#define SOMS_SKIP_IN_SLOW_BUILDS()                                                 \
  do {                                                                             \
    if (soms::test::kSlowBuild) {                                                  \
      GTEST_SKIP() << "takes long in this build: the release suite alone runs it"; \
    }                                                                              \
  } while (false)
