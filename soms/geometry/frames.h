/// \file
/// Do the numbers of two models mean the same? Compared by the unit and up axis that they declare,
/// and by how far apart their boxes are.
#pragma once

#include "soms/base/box.h"
#include "soms/base/words.h"
#include "soms/geometry/mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace soms {

/// What the coordinates of a model mean, as far as it is known: by its file, or by the caller.
struct CoordinateFrame {
  double unit = 0;              ///< meters a unit; 0: not declared
  UpAxis up = UpAxis::unknown;  ///< as the coordinates stand now
  bool unit_is_stated = false;  ///< the caller answers for the unit, which two files may contradict
  bool up_is_stated = false;    ///< the caller answers for `up`, which a file may contradict
  double scale = 1;  ///< the caller multiplied the coordinates by it; `unit` is that of the product
  Georeference georeference = {};       ///< of the coordinates as they stand now
  bool georeference_is_stated = false;  ///< the caller answers for it

  [[nodiscard]] bool operator==(const CoordinateFrame&) const = default;
};

/// What a mesh declares.
[[nodiscard]] CoordinateFrame frame_of(const MeshView& mesh);

/// Why "no overlap" may not mean "free": the numbers of the two bodies may not mean the same.
enum class FrameDoubt {
  axes_differ,           ///< the up axes of both are known, and differ
  axis_unknown,          ///< one declares its up axis, of the other none is known
  units_differ,          ///< both declare a unit, and not the same
  unit_unknown,          ///< one declares a unit, the other does not
  georeferences_differ,  ///< both say where on the Earth they lie, and not in the same way
  georeference_unknown,  ///< one says where on the Earth it lies, the other does not
  boxes_apart,           ///< `far_apart` holds
};

template <>
inline constexpr auto kWords<FrameDoubt> =
    words("FrameDoubt", "Why the numbers of two bodies may not mean the same.", "axes_differ",
          "axis_unknown", "units_differ", "unit_unknown", "georeferences_differ",
          "georeference_unknown", "boxes_apart");

/// True if two units, in meters, are the same but for the rounding of a float.
[[nodiscard]] bool same_unit(double a, double b);

/// Doubts about what two models declare, axes before units, georeferences last; none where neither
/// declares anything.
/// Axes that are known and differ are always a doubt. An axis that is unknown is none where the
/// other is stated by the caller, who has looked at both; an unknown unit is none where either is
/// stated. Units that are known and not `same_unit` are a doubt unless the caller states the unit
/// of either and left its numbers alone (`scale` 1): a scale that does not fit contradicts the
/// files. Georeferences that are not the same are a doubt, and so is one beside none, unless the
/// caller states the one that there is. Whoever places the second model by a pose takes its
/// georeference out of its frame first. Symmetric.
[[nodiscard]] std::vector<FrameDoubt> compare_frames(const CoordinateFrame& a,
                                                     const CoordinateFrame& b);

/// A doubt about declared frames in words, "the up axis is y in b.gltf, and unknown in a.obj".
/// \pre `doubt` is not `boxes_apart`.
[[nodiscard]] std::string explain(FrameDoubt doubt, const CoordinateFrame& a,
                                  const std::string& name_a, const CoordinateFrame& b,
                                  const std::string& name_b);

/// The greatest gap of two boxes along an axis; 0 where they overlap, touch, or one is empty.
[[nodiscard]] double gap(const Box& a, const Box& b);

/// True if the gap of two boxes is greater than the longest side of either: where a unit, an axis
/// or a shift is missing, bodies that belong together often are. Bodies may be so on purpose.
[[nodiscard]] bool far_apart(const Box& a, const Box& b);

}  // namespace soms
