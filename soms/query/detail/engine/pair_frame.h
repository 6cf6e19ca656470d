/// \file
/// A pair of bodies as queries see it: the larger one is the reference frame, in whose axes the
/// other one is seen.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/body.h"
#include "soms/query/detail/relative_pose.h"

#include <cstddef>
#include <optional>
#include <span>

namespace soms::detail {

/// A shape at a pose, as one side of a query.
struct PosedShape {
  const Shape* shape;
  const Pose* pose;

  [[nodiscard]] const WideTree& layout() const { return shape->layout(); }
};

[[nodiscard]] bool is_empty(const Shape& shape);

/// One of two shapes at least is compact.
[[nodiscard]] bool any_compact(const Shape& a, const Shape& b);

/// Throws unless the pose is rigid and keeps the shape within range. \pre The caller holds a
/// PlainArithmetic.
void check_pose(const Pose& pose, const Shape& shape);

/// Two posed shapes. Side y is the reference frame: the tree of the coarser unit, or else the
/// larger one. Side x is the other. Refers to the shapes and poses it was made of.
class PairFrame {
 public:
  /// The two are one body, as in a SelfFrame.
  static constexpr bool kSelf = false;

  /// \pre Neither shape is empty; the poses have passed their checks.
  PairFrame(const Body& a, const Body& b);

  /// The same of known sides, `y` prepared; `swapped` if they are the caller's b and a.
  PairFrame(const PosedShape& x, const PosedShape& y, const ReferenceFrame& reference, bool swapped)
      : x_(x), y_(y), swapped_(swapped), relative_(x.layout(), *x.pose, reference) {}

  /// The same with a relative pose found among others.
  PairFrame(const PosedShape& x, const PosedShape& y, const RelativePoses& poses, std::size_t i,
            bool swapped)
      : x_(x), y_(y), swapped_(swapped), relative_(x.layout(), y.layout(), poses, i) {}

  PairFrame(const PairFrame&) = delete;
  PairFrame& operator=(const PairFrame&) = delete;
  ~PairFrame() = default;

  [[nodiscard]] const PosedShape& x() const { return x_; }

  [[nodiscard]] const PosedShape& y() const { return y_; }

  [[nodiscard]] RelativePose& relative() { return relative_; }

  [[nodiscard]] const RelativePose& relative() const { return relative_; }

  /// x and y are the caller's b and a.
  [[nodiscard]] bool swapped() const { return swapped_; }

  /// A triangle of x and one of y as a pair of the caller's a and b.
  [[nodiscard]] TrianglePair in_callers_order(TriangleId x, TriangleId y) const {
    return swapped_ ? TrianglePair{y, x} : TrianglePair{x, y};
  }

 private:
  PairFrame(const PosedShape& a, const PosedShape& b, bool swapped);

  PosedShape x_;
  PosedShape y_;
  bool swapped_;
  RelativePose relative_;
};

/// The frames of a shape at many poses beside one body, whose share is prepared once.
class PoseFrames {
 public:
  /// \pre As for PairFrame.
  PoseFrames(const Shape& mover, const Body& fixed);

  /// Puts the pair of the mover at `pose` and the fixed body in place of what `frame` held.
  void place(const Pose& pose, std::optional<PairFrame>& frame) const;

  /// Finds the relative poses of up to RelativePoses::kMost poses.
  void find(std::span<const Pose* const> poses, RelativePoses& found) const;

  /// `place`, where `find` has found the relative pose as the `i`-th.
  void place(const Pose& pose, const RelativePoses& found, std::size_t i,
             std::optional<PairFrame>& frame) const;

  /// The tree that is the reference frame at all poses.
  [[nodiscard]] const WideTree& reference() const {
    return mover_is_reference_ ? mover_->layout() : fixed_.layout();
  }

 private:
  const Shape* mover_;
  PosedShape fixed_;
  bool mover_is_reference_;
  ReferenceFrame fixed_frame_;
  MovedNumbers moved_;
  BoxNumbers box_;
};

}  // namespace soms::detail
