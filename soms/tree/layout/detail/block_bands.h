/// \file
/// Columns and heights that the triangles of a block reach into, four lanes at once.
///
/// Proof. In units of columns, with q a corner's coordinate about the block's origin, s the columns
/// a unit, L the block's largest |q| and f < 1 what the origin's column has of a fraction: f and s
/// are rounded once, their product with q and the sum with f once each, and corners are known to
/// 2^-23 L. So a place is off by less than 2^-21 (L s + 1), of which columns of doubles, places of
/// at most 2^22, are off by 2^-28. Moved outward by 2^-20 (L s + 1), which is rounded twice, it
/// lies on the right side of every column that ground_plan.h finds for a point of the triangle.
/// What corners lost when they were taken about the tree's and the block's origins, 2^-52 of the
/// mesh's size, is in what a query's box gives way by (relative_pose.h).
#pragma once

#include "soms/base/lanes.h"
#include "soms/tree/layout/detail/column_bands.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace soms::layout {

/// Where a block lies above the ground plan.
class BlockPlace {
 public:
  /// \param scale turns the mesh's units into those of the layout
  BlockPlace(const TriangleBlock& block, double scale, const GroundPlan& plan)
      : block_(&block),
        axes_(plan.axis),
        scale_(scale),
        columns_a_unit_(static_cast<float>(plan.columns_a_unit)) {
    const float outward = 0x1p-20F * (block.l1_radius * columns_a_unit_ + 1);
    for (std::size_t k = 0; k < 2; ++k) {
      const double origin = (block.origin[axes_[k]] * scale - plan.origin[k]) * plan.columns_a_unit;
      const double whole = std::floor(std::clamp(origin, 0.0, plan.last[k]));
      const auto part = static_cast<float>(origin - whole);
      base_[k] = static_cast<std::int32_t>(whole);
      last_[k] = static_cast<std::int32_t>(plan.last[k]);
      low_part_[k] = part - outward;
      high_part_[k] = part + outward;
    }
    height_ = block.origin[axes_[2]] * scale;
  }

  /// The bounds of all triangles: as all steps are monotone, those of the least and the greatest
  /// corner.
  [[nodiscard]] ColumnBand whole() const {
    ColumnBand band;
    for (std::size_t k = 0; k < 2; ++k) {
      const Ends range = ends_of_all(k);
      band.from[k] = static_cast<std::uint32_t>(columns(k, range.least, low_part_)[0]);
      band.to[k] = static_cast<std::uint32_t>(columns(k, range.most, high_part_)[0]);
    }
    const Ends range = ends_of_all(2);
    band.lower = float_below(height_ + (static_cast<double>(range.least[0]) - give()));
    band.upper = float_above(height_ + (static_cast<double>(range.most[0]) + give()));
    return band;
  }

 protected:
  using F4 = lanes::F4;
  using I4 [[gnu::vector_size(16)]] = std::int32_t;
  static constexpr std::size_t kWidth = TriangleBlock::kWidth;

  struct Ends {
    F4 least;
    F4 most;
  };

  // Corners in a block are rounded to nearest.
  [[nodiscard]] double give() const { return 0x1p-23 * static_cast<double>(block_->l1_radius); }

  /// Least and greatest corners of four triangles on an axis.
  [[nodiscard]] Ends ends(std::size_t k, std::size_t first) const {
    const F4 a = row(axes_[k], first);
    const F4 b = row(axes_[k] + std::size_t{3}, first);
    const F4 c = row(axes_[k] + std::size_t{6}, first);
    return {lanes::min(lanes::min(a, b), c), lanes::max(lanes::max(a, b), c)};
  }

  /// First or last columns of what reaches to `at`.
  [[nodiscard]] I4 columns(std::size_t k, F4 at, const std::array<float, 2>& part) const {
    return within(splat(base_[k]) + floor(at * columns_a_unit_ + lanes::splat(part[k])),
                  splat(last_[k]));
  }

  const TriangleBlock* block_;
  std::array<std::uint8_t, 3> axes_;
  double scale_;
  double height_;  ///< of the block's origin
  float columns_a_unit_;
  std::array<std::int32_t, 2> base_;  ///< column of the block's origin
  std::array<std::int32_t, 2> last_;
  std::array<float, 2> low_part_;  ///< what the origin's column has of a fraction, moved outward
  std::array<float, 2> high_part_;

 private:
  [[nodiscard]] F4 row(std::size_t row, std::size_t first) const {
    F4 v;
    std::memcpy(&v, block_->corner[row].data() + first, sizeof v);
    return v;
  }

  /// Those of all triangles, in lane 0.
  [[nodiscard]] Ends ends_of_all(std::size_t k) const {
    Ends all = ends(k, 0);
    const Ends more = ends(k, 4);
    all = {lanes::min(all.least, more.least), lanes::max(all.most, more.most)};
    all = {lanes::min(all.least, __builtin_shufflevector(all.least, all.least, 2, 3, 0, 1)),
           lanes::max(all.most, __builtin_shufflevector(all.most, all.most, 2, 3, 0, 1))};
    return {lanes::min(all.least, __builtin_shufflevector(all.least, all.least, 1, 0, 3, 2)),
            lanes::max(all.most, __builtin_shufflevector(all.most, all.most, 1, 0, 3, 2))};
  }

  static I4 splat(std::int32_t x) { return I4{x, x, x, x}; }

  static I4 floor(F4 x) {
    const I4 toward_zero = __builtin_convertvector(x, I4);
    return toward_zero + (__builtin_convertvector(toward_zero, F4) > x);
  }

  /// At least 0, at most `last`.
  static I4 within(I4 x, I4 last) {
    const I4 positive = x & ~(x >> 31);
    const I4 over = positive > last;
    return (positive & ~over) | (last & over);
  }
};

/// The same, and the bounds of each triangle.
class BlockBands : public BlockPlace {
 public:
  explicit BlockBands(const BlockPlace& place) : BlockPlace(place) {
    for (std::size_t first = 0; first < kWidth; first += 4) {
      for (std::size_t k = 0; k < 2; ++k) {
        const auto [least, most] = ends(k, first);
        store(columns(k, least, low_part_), from_[k], first);
        store(columns(k, most, high_part_), to_[k], first);
      }
      const auto [least, most] = ends(2, first);
      for (std::size_t i = 0; i < 4; ++i) {
        const int lane = static_cast<int>(i);
        lower_[first + i] = float_below(height_ + (static_cast<double>(least[lane]) - give()));
        upper_[first + i] = float_above(height_ + (static_cast<double>(most[lane]) + give()));
      }
    }
  }

  [[nodiscard]] ColumnBand band(std::size_t lane) const {
    return {
        {from_[0][lane], from_[1][lane]}, {to_[0][lane], to_[1][lane]}, lower_[lane], upper_[lane]};
  }

  [[nodiscard]] PlanTriangle triangle(std::size_t lane) const {
    PlanTriangle triangle;
    triangle.give = give();
    for (std::size_t i = 0; i < 3; ++i) {
      const double place = block_->origin[axes_[i]] * scale_;
      for (std::size_t c = 0; c < 3; ++c) {
        triangle.corner[c][i] = place + static_cast<double>(block_->corner[3 * c + axes_[i]][lane]);
      }
    }
    return triangle;
  }

 private:
  static void store(I4 v, std::array<std::uint32_t, kWidth>& to, std::size_t first) {
    std::memcpy(to.data() + first, &v, sizeof v);
  }

  std::array<std::array<std::uint32_t, kWidth>, 2> from_;
  std::array<std::array<std::uint32_t, kWidth>, 2> to_;
  std::array<float, kWidth> lower_;
  std::array<float, kWidth> upper_;
};

}  // namespace soms::layout
