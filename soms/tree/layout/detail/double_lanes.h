/// \file
/// Four doubles side by side, for code that is compiled for several instruction sets: nothing here
/// is ever passed, all is inlined.
#pragma once

#include <cstddef>

#if defined(__GNUC__)
// How vectors would be passed without AVX does not matter: nothing passes them.
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace soms::layout {

using D4 [[gnu::vector_size(32)]] = double;

[[gnu::always_inline]] inline D4 all_lanes(double x) {
  return D4{x, x, x, x};
}

[[gnu::always_inline]] inline D4 lesser(const D4& a, const D4& b) {
  return b < a ? b : a;
}

[[gnu::always_inline]] inline D4 greater(const D4& a, const D4& b) {
  return b > a ? b : a;
}

}  // namespace soms::layout
