#include "soms/query/detail/triangle_tests.h"

#include "soms/query/detail/query_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace soms::detail {

namespace {

using Three = std::array<F4, 3>;

/// Covers what underflows in products of three or four lengths.
constexpr float kLeastProduct = 0x1p-140F;
/// More than underflow takes from the three products of a normal and an axis, which are then
/// multiplied by a length that may be large.
constexpr float kLeastAlong = 0x1p-147F;

F4 least(F4 a, F4 b, F4 c) {
  return min(a, min(b, c));
}

F4 greatest(F4 a, F4 b, F4 c) {
  return max(a, max(b, c));
}

Three cross(const Three& a, const Three& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

F4 dot(const Three& a, F4 x, F4 y, F4 z) {
  return (a[0] * x + a[1] * y) + a[2] * z;
}

F4 sum_of_magnitudes(const Three& n) {
  return (abs(n[0]) + abs(n[1])) + abs(n[2]);
}

Three normal_of(const std::array<F4, 9>& q) {
  return cross({q[3] - q[0], q[4] - q[1], q[5] - q[2]}, {q[6] - q[0], q[7] - q[1], q[8] - q[2]});
}

/// At least the lengths but for 2^-21 of them. Squares of small coordinates underflow.
F4 lengths_of(const Three& n) {
  constexpr float kSmall = 0x1p-40F;
  const F4 squares = dot(n, n[0], n[1], n[2]);
  const F4 magnitudes = sum_of_magnitudes(n);
  F4 lengths = {};
  for (std::size_t k = 0; k < 4; ++k) {
    lengths[k] = magnitudes[k] < kSmall ? magnitudes[k] : std::sqrt(squares[k]);
  }
  return lengths;
}

/// A box seen from the triangles' frame: axis j of the box is column j of `axis`.
struct SeenBox {
  std::array<float, 3> center;
  std::array<float, 3> half;
  std::array<std::array<float, 4>, 3> axis;  // rows padded to four
  std::array<float, 3> radius;               // along the triangles' axes, margin included
  float margin;
  float reach;  // what may lie between, beside the margin

  void finish() {
    for (std::size_t i = 0; i < 3; ++i) {
      radius[i] = ((std::abs(axis[i][0]) * half[0] + std::abs(axis[i][1]) * half[1]) +
                   std::abs(axis[i][2]) * half[2]) +
                  (margin + reach);
    }
  }
};

/// Triangles that miss the box along their own directions `n`.
M4 apart_along(const SeenBox& box, const std::array<F4, 9>& q, const Three& n) {
  F4 bound = sum_of_magnitudes(n) * box.margin + kLeastProduct;
  if (box.reach != 0) {
    bound += lengths_of(n) * (box.reach * (1 + 0x1p-20F));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const F4 along = (n[0] * box.axis[0][j] + n[1] * box.axis[1][j]) + n[2] * box.axis[2][j];
    bound += (abs(along) + kLeastAlong) * box.half[j];
  }
  const F4 a = dot(n, q[0], q[1], q[2]);
  const F4 b = dot(n, q[3], q[4], q[5]);
  const F4 c = dot(n, q[6], q[7], q[8]);
  return (least(a, b, c) > bound) | (greatest(a, b, c) < -bound);
}

/// Four triangles, corners about the box's center.
std::uint32_t apart(const SeenBox& box, const std::array<F4, 9>& q, bool small) {
  M4 sum = {};
  for (std::size_t i = 0; i < 3; ++i) {
    sum |= (least(q[i], q[3 + i], q[6 + i]) > splat(box.radius[i])) |
           (greatest(q[i], q[3 + i], q[6 + i]) < splat(-box.radius[i]));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const Three axis = {splat(box.axis[0][j]), splat(box.axis[1][j]), splat(box.axis[2][j])};
    const F4 a = dot(axis, q[0], q[1], q[2]);
    const F4 b = dot(axis, q[3], q[4], q[5]);
    const F4 c = dot(axis, q[6], q[7], q[8]);
    const float bound = box.half[j] + (box.margin + box.reach);
    sum |= (least(a, b, c) > splat(bound)) | (greatest(a, b, c) < splat(-bound));
  }
  if (bits_of(sum) == 0xf) {
    return 0xf;
  }
  const Three n = normal_of(q);
  sum |= apart_along(box, q, n);
  if (!small || bits_of(sum) == 0xf) {
    return bits_of(sum);
  }
  // Across the edges, in the triangles' planes: large triangles beside a small box.
  for (std::size_t corner = 0; corner < 9; corner += 3) {
    const std::size_t next = (corner + 3) % 9;
    sum |= apart_along(
        box, q,
        cross(n, {q[next] - q[corner], q[next + 1] - q[corner + 1], q[next + 2] - q[corner + 2]}));
  }
  return bits_of(sum);
}

std::uint32_t meeting(const SeenBox& box, const TriangleBlock& block, float ratio) {
  const bool small =
      2 * std::max({box.half[0], box.half[1], box.half[2]}) < block.l1_radius * ratio;
  std::uint32_t bits = 0;
  for (std::uint32_t first = 0; first < block.count; first += 4) {
    std::array<F4, 9> q;
    for (std::size_t row = 0; row < 9; ++row) {
      q[row] = load(block.corner[row], first) * ratio - box.center[row % 3];
    }
    bits |= (~apart(box, q, small) & 0xf) << first;
  }
  return bits & ((1U << block.count) - 1);
}

}  // namespace

std::uint32_t box_against_y(const Relation& relation, const std::array<float, 3>& half_x,
                            const TriangleBlock& y, float reach) {
  const float ratio = relation.ratio;
  SeenBox box;
  box.center = relation.offset;
  box.half = {half_x[0] * ratio, half_x[1] * ratio, half_x[2] * ratio};
  box.axis = relation.turn->entry;
  box.margin = relation.margin;
  box.reach = reach;
  box.finish();
  return meeting(box, y, 1);
}

std::uint32_t box_against_x(const Relation& relation, const TriangleBlock& x,
                            const std::array<float, 3>& half_y, float reach) {
  const auto& n = relation.turn->entry;
  const auto& d = relation.offset;
  SeenBox box;
  for (std::size_t j = 0; j < 3; ++j) {
    box.center[j] = -((n[0][j] * d[0] + n[1][j] * d[1]) + n[2][j] * d[2]);
    box.axis[j] = {n[0][j], n[1][j], n[2][j], 0};
  }
  box.half = half_y;
  box.margin = relation.margin;
  box.reach = reach;
  box.finish();
  return meeting(box, x, relation.ratio);
}

}  // namespace soms::detail
