/// \file
/// An interval of a measured value.
#pragma once

namespace soms::reproduce {

/// A closed range of numbers.
struct Interval {
  double low = 0;
  double high = 0;
};

}  // namespace soms::reproduce
