/// \file
/// Four doubles side by side, for code that is compiled for several instruction sets. Functions
/// that take or return them must be inlined by force: otherwise callers for AVX pass them in other
/// places than callees without it expect. So none is a lambda.
#pragma once

#include <cstddef>

#if defined(__GNUC__)
// GCC warns of how they would be passed.
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
