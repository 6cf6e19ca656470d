#include "soms/query/detail/engine/pair_frame.h"

#include "soms/query/detail/kernels/instruction_set.h"

#include <algorithm>

namespace soms::detail {

namespace {

/// True if a pair of trees is seen in the axes of `a`.
bool first_is_reference(const WideTree& a, const WideTree& b) {
  if (a.exponent() != b.exponent()) {
    return a.exponent() < b.exponent();
  }
  const auto size = [](const WideTree& tree) {
    const Vec3 extent = tree.bounds().extent();
    return std::max({extent.x, extent.y, extent.z});
  };
  return size(a) > size(b);
}

}  // namespace

bool is_empty(const Shape& shape) {
  return shape.layout().empty();
}

bool any_compact(const Shape& a, const Shape& b) {
  return a.layout().compact() != nullptr || b.layout().compact() != nullptr;
}

void check_pose(const Pose& pose, const Shape& shape) {
  if (!passes_checks(pose, shape.bounds())) {
    check(pose);
    check_range(pose, shape.bounds());
  }
}

PairFrame::PairFrame(const Body& a, const Body& b)
    : PairFrame({&a.shape, &a.pose}, {&b.shape, &b.pose},
                first_is_reference(a.shape.layout(), b.shape.layout())) {
}

PairFrame::PairFrame(const PosedShape& a, const PosedShape& b, bool swapped)
    : PairFrame(swapped ? b : a, swapped ? a : b,
                swapped ? ReferenceFrame(a.layout(), *a.pose) : ReferenceFrame(b.layout(), *b.pose),
                swapped) {
}

PoseFrames::PoseFrames(const Shape& mover, const Body& fixed)
    : mover_(&mover),
      fixed_{&fixed.shape, &fixed.pose},
      mover_is_reference_(first_is_reference(mover.layout(), fixed.shape.layout())),
      fixed_frame_(fixed.shape.layout(), fixed.pose),
      moved_(moved_numbers(mover.layout())) {
  const layout::MinMaxGrid& grid = fixed.shape.layout().min_max_grid();
  box_ = {fixed.shape.layout().scale(), grid.empty() ? nullptr : &grid.plan()};
}

void PoseFrames::find(std::span<const Pose* const> poses, RelativePoses& found) const {
  if (mover_is_reference_) {
    found.apart = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const RelativePose relative(fixed_.layout(), *fixed_.pose,
                                  ReferenceFrame(mover_->layout(), *poses[i]));
      SingleBox box = {};
      relative.single_box(box);
      box.find_place(mover_->layout());
      relative.put(found, i, box);
    }
  } else {
    kernels().relative_poses(moved_, fixed_frame_, box_, poses.data(), poses.size(), found);
    found.residual.fill(fixed_frame_.residual);
  }
}

void PoseFrames::place(const Pose& pose, const RelativePoses& found, std::size_t i,
                       std::optional<PairFrame>& frame) const {
  const PosedShape mover{mover_, &pose};
  if (mover_is_reference_) {
    frame.emplace(fixed_, mover, found, i, true);
  } else {
    frame.emplace(mover, fixed_, found, i, false);
  }
}

void PoseFrames::place(const Pose& pose, std::optional<PairFrame>& frame) const {
  const PosedShape mover{mover_, &pose};
  if (mover_is_reference_) {
    frame.emplace(fixed_, mover, ReferenceFrame(mover_->layout(), pose), true);
  } else {
    frame.emplace(mover, fixed_, fixed_frame_, false);
  }
}

}  // namespace soms::detail
