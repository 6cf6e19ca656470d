/// \file
/// How far a body moves freely, which is what poses that only just touch are made from.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/vector.h"

#include <functional>
#include <optional>

namespace soms::bench {

/// How a motion is searched for its first contact. Lengths are in the motion's own measure: meters
/// along a line, radians of a joint.
struct Search {
  double step = 0;   ///< contacts shorter than this may be missed
  double reach = 0;  ///< how far to look
  double within = 1e-4;
};

/// How far a motion stays free: `touches` holds at most `within` beyond. Nothing where it touches
/// from the start or nowhere within reach.
[[nodiscard]] std::optional<double> free_way(const std::function<bool(double way)>& touches,
                                             const Search& search);

/// The pose shifted along a line.
[[nodiscard]] Pose onward(const Pose& start, const Vec3& direction, double distance);

}  // namespace soms::bench
