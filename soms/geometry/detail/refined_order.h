/// \file
/// Comparing distances that are known better and better, until they are decided.
#pragma once

#include "soms/base/arithmetic.h"

#include <compare>

namespace soms::detail {

/// A friend of `Distance`, which has bounds `lower_` and `upper_` and knows how to refine them.
template <class Distance>
struct RefinedOrder {
  /// The order of two distances.
  [[nodiscard]] static std::strong_ordering compare(Distance& a, Distance& b) {
    const PlainArithmetic plain;
    for (;;) {
      if (a.lower_ > b.upper_) {
        return std::strong_ordering::greater;
      }
      if (a.upper_ < b.lower_) {
        return std::strong_ordering::less;
      }
      if ((a.is_number() && b.is_number()) || a.has_features_of(b)) {
        return std::strong_ordering::equal;
      }
      if (a.is_exact() && b.is_exact()) {
        return a.compare_exactly(b);
      }
      Distance& next = a.less_refined(b) ? a : b;
      next.refine();
    }
  }

  /// How a distance stands to a number, which is not negative, but may be infinite.
  [[nodiscard]] static std::strong_ordering compare(Distance& a, double distance) {
    const PlainArithmetic plain;
    for (;;) {
      if (a.lower_ > distance) {
        return std::strong_ordering::greater;
      }
      if (a.upper_ < distance) {
        return std::strong_ordering::less;
      }
      if (a.is_number()) {
        return std::strong_ordering::equal;
      }
      if (a.is_exact()) {
        return a.compare_exactly(distance);
      }
      a.refine();
    }
  }
};

}  // namespace soms::detail
