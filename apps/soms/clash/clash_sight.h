/// \file
/// From where a clash is seen best.
#pragma once

#include "apps/soms/clash/clash_listed.h"

#include <optional>

namespace soms::command {

/// A camera that looks at a clash. Up is z.
struct ClashSight {
  Vec3 place = {};           ///< of the clash
  Vec3 focus = {};           ///< what the camera looks at: the middle of the clash's box
  double reach = 1;          ///< radius around `focus` that is worth seeing
  Vec3 toward = {};          ///< unit vector from `focus` to the eye
  bool a_is_larger = false;  ///< part `a` is thicker: it is drawn so that one sees through it

  /// Of all that is drawn, what is nearer to the eye than the plane through this point, at right
  /// angles to `toward`, is cut away, but for the two parts.
  [[nodiscard]] Vec3 cut() const { return focus + kCut * reach * toward; }

  /// All within `reach` of `focus` is in a picture whose height is seen at `kFieldOfView`.
  [[nodiscard]] Vec3 eye() const { return focus + kDistance * reach * toward; }

  static constexpr double kCut = 0.1;
  static constexpr double kFieldOfView = 45;  ///< degrees
  static constexpr double kDistance = 2.62;   ///< 1 / sin(kFieldOfView / 2), rounded up
  static constexpr double kTangent = 0.41421356237309503;  ///< tan(kFieldOfView / 2)
};

/// A direction from which the two parts hide the place least; of equal ones that which is most like
/// a view from the front, the right and above. Nothing where the row has no place.
/// \cost A few rays to each of the two parts.
[[nodiscard]] std::optional<ClashSight> sight_of(const ClashModels& models,
                                                 const ListedClash& clash);

}  // namespace soms::command
