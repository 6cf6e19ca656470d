/// \file
/// Whether this build is slow, so that the largest cases are cut.
#pragma once

namespace soms::test {

/// True in debug and sanitizer builds (SOMS_ASSERTIONS in cmake/options.cmake).
#if SOMS_ASSERTIONS
inline constexpr bool kSlowBuild = true;
#else
inline constexpr bool kSlowBuild = false;
#endif

}  // namespace soms::test
