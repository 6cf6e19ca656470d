/// \file
/// Which features of two triangles are nearest, as far as plain doubles can tell.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/distance_ends.h"
#include "soms/geometry/detail/feature_pair.h"

#include <array>

namespace soms::detail {

/// Features that a shortest segment joins, or nearly so; nothing depends on their being right.
/// \pre The corners, three of each triangle, have magnitudes in [0, 2^110] and are about one of
/// them.
[[nodiscard]] FeaturePair guess_features(const std::array<Vec3, 6>& corners);

/// The same for triangles as they are.
[[nodiscard]] FeaturePair guess_features(const Triangle& a, const Triangle& b);

[[nodiscard]] FeaturePair guess_features(const AboutCorner<double>& place);

}  // namespace soms::detail
