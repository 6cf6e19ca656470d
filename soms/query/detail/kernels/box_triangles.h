// The triangles of a block against a box: a large leaf beside a small node. relative_pose.h proves
// the margins. Included after triangle_pairs.h, once for each instruction set.
//
// Underflow. Products of a length and an entry of a rotation, in radii and centers, lose 2^-150:
// `margin` has 2^-100 for them. A direction n, a product of two or three lengths, may lose all of
// itself: what is left is a direction, too, and 0 parts nothing. Its products with corners, half
// sides, margin and reach lose 2^-150 each, less than 2^-145 in all: kLeastProduct. Those with the
// box's axes are multiplied on: kLeastAlong. A bound that is not a number (no limit of nearness, n
// being 0) parts nothing.

/// More than underflow takes from the three products of a normal and an axis, which are then
/// multiplied by a length that may be large.
inline constexpr float kLeastAlong = 0x1p-147F;

/// At least the lengths but for 2^-21 of them. Squares of small coordinates underflow.
inline F8 lengths_of(const Three& n) {
  const F8 magnitudes = sum_of_magnitudes(n);
  return select(F8(0x1p-40F) > magnitudes, magnitudes, sqrt(dot<F8>(n, n)));
}

/// Triangles that miss the box along their own directions `n`.
inline M8 apart_along(const SeenBox& box, const Corners& q, const Three& n) {
  F8 bound = sum_of_magnitudes(n) * F8(box.margin) + F8(kLeastProduct);
  if (box.reach != 0) {
    bound = bound + lengths_of(n) * F8(box.reach * (1 + 0x1p-20F));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const F8 along =
        (n[0] * F8(box.axis[0][j]) + n[1] * F8(box.axis[1][j])) + n[2] * F8(box.axis[2][j]);
    bound = bound + (abs(along) + F8(kLeastAlong)) * F8(box.half[j]);
  }
  const F8 a = dot<F8>(n, q[0]);
  const F8 b = dot<F8>(n, q[1]);
  const F8 c = dot<F8>(n, q[2]);
  return (least(a, b, c) > bound) | (F8(0.0F) - bound > greatest(a, b, c));
}

/// Triangles that some axis of the block's or of the box parts from the box.
inline M8 apart_on_axes(const SeenBox& box, const Corners& q) {
  M8 apart = F8(0.0F) > F8(0.0F);
  for (std::size_t i = 0; i < 3; ++i) {
    apart = apart | (least(q[0][i], q[1][i], q[2][i]) > F8(box.radius[i])) |
            (F8(-box.radius[i]) > greatest(q[0][i], q[1][i], q[2][i]));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const Three axis = {F8(box.axis[0][j]), F8(box.axis[1][j]), F8(box.axis[2][j])};
    const F8 a = dot<F8>(axis, q[0]);
    const F8 b = dot<F8>(axis, q[1]);
    const F8 c = dot<F8>(axis, q[2]);
    const float bound = box.half[j] + (box.margin + box.reach);
    apart = apart | (least(a, b, c) > F8(bound)) | (F8(-bound) > greatest(a, b, c));
  }
  return apart;
}

inline std::uint32_t meet_box(const SeenBox& box, const TriangleBlock& block, float ratio) {
  const std::uint32_t wanted = (1U << block.count) - 1;
  Corners q = corners_of(block);
  for (Three& corner : q) {
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] = corner[i] * F8(ratio) - F8(box.center[i]);
    }
  }
  std::uint32_t meet = wanted & ~bits(apart_on_axes(box, q));
  if (meet == 0) {
    return 0;
  }
  const Three normal = cross(minus(q[1], q[0]), minus(q[2], q[0]));
  meet &= ~bits(apart_along(box, q, normal));
  if (meet == 0 ||
      !(2 * std::max({box.half[0], box.half[1], box.half[2]}) < block.l1_radius * ratio)) {
    return meet;
  }
  // Across the edges, in the triangles' planes: large triangles beside a small box.
  M8 apart = F8(0.0F) > F8(0.0F);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    apart = apart | apart_along(box, q, cross(normal, minus(q[(corner + 1) % 3], q[corner])));
  }
  return meet & ~bits(apart);
}
