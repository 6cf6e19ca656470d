/// \file
/// Pictures of clashes, drawn without a graphics card: the same pixels on every machine.
#pragma once

#include "apps/draw/picture.h"
#include "apps/soms/clash/clash_sight.h"

#include <vector>

namespace soms::command {

/// Draws clashes of the same models.
class ClashPainter {
 public:
  /// `models` must stay.
  explicit ClashPainter(const ClashModels& models);

  /// The two parts in the colors of A and B of all pictures, the thicker so that one sees through
  /// it, what is around them pale and cut away toward the eye, the place as a red dot.
  /// \cost    O(p + t) for p parts and t triangles of the parts that are near.
  /// \threads Any number of callers.
  [[nodiscard]] look::Picture draw(const ListedClash& clash, const ClashSight& sight) const;

  static constexpr look::Size kSize{480, 360};

 private:
  const ClashModels& models_;
  std::vector<Box> of_a_;  ///< bounds of the parts
  std::vector<Box> of_b_;
};

}  // namespace soms::command
