// Relative poses of many poses, kDoubles at a time. Included inside a namespace, after
// lanes_double.h. Half sides that are subnormal floats are off by 2^-150: kSlackOfLengths.

using Real = WideDouble;
using Flag = MaskDouble;

#include "soms/query/detail/kernels/relative.h"

/// As many floats.
using WideFloat [[gnu::vector_size(4 * kDoubles)]] = float;

inline WideFloat narrow(const WideDouble& a) {
  return __builtin_convertvector(a.v, WideFloat);
}

inline WideDouble widen(const WideFloat& a) {
  return WideDouble(__builtin_convertvector(a, WideDouble::Lanes));
}

template <class Lanes, class Row>
inline void store(const Lanes& a, Row& row, std::size_t first) {
  static_assert(sizeof a == kDoubles * sizeof row[0]);
  std::memcpy(row.data() + first, &a, sizeof a);
}

/// Entries of poses, side by side.
inline std::array<Real, 12> entries_of(const std::array<const Pose*, kDoubles>& poses) {
  std::array<std::array<double, kDoubles>, 12> entries;
  for (std::size_t k = 0; k < kDoubles; ++k) {
    for (std::size_t e = 0; e < 12; ++e) {
      entries[e][k] = poses[k]->m[e];
    }
  }
  std::array<Real, 12> m;
  for (std::size_t e = 0; e < 12; ++e) {
    m[e] = Real::load(entries[e]);
  }
  return m;
}

/// `SingleBox`, and its place, of poses whose shift, half sides and slack are found.
inline void find_boxes(const BoxNumbers& y, const std::array<Real, 3>& shift,
                       const std::array<Real, 3>& half_seen, const Real& slack_of_mesh,
                       std::size_t first, RelativePoses& found) {
  const Real scaled = slack_of_mesh * Real(y.scale);
  const Flag outweighs = scaled > Real(kMostSlackOfPoses);
  const Real scale = select(outweighs, Real(0), Real(y.scale));
  const Real plus = scaled + Real(kSlackOfLengths);
  const Real up = plus + (abs(plus) * Real(0x1p-22) + Real(0x1p-100));
  const WideFloat slack = narrow(select(outweighs, Real(0x1p100), up));
  std::array<WideFloat, 3> half;
  for (std::size_t i = 0; i < 3; ++i) {
    half[i] = narrow(half_seen[i] * scale);
    store(half[i], found.half[i], first);
  }
  const WideFloat sum = (half[0] + half[1]) + half[2];
  store(sum, found.sum, first);
  store(slack, found.slack, first);
  store(scale, found.scale, first);
  if (y.plan == nullptr) {
    return;
  }
  const layout::GroundPlan& plan = *y.plan;
  const Real margin = widen(sum * BoxNumbers::kMargin + slack);
  std::array<Real, 3> lower;
  std::array<Real, 3> upper;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t axis = plan.axis[k];
    const Real at = shift[axis] * scale;
    const Real reach = widen(half[axis]) + margin;
    lower[k] = at - reach;
    upper[k] = at + reach;
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const auto column = [&](const Real& x) {
      const Real place = (x - Real(plan.origin[k])) * Real(plan.columns_a_unit);
      return min(max(place, Real(0)), Real(plan.last[k]));
    };
    store(column(lower[k]), found.from[k], first);
    store(column(upper[k]), found.to[k], first);
  }
  store(lower[2], found.lower, first);
  store(upper[2], found.upper, first);
}

inline void relative_poses(const MovedNumbers& x, const ReferenceNumbers& y, const BoxNumbers& box,
                           const Pose* const* poses, std::size_t count, RelativePoses& found) {
  static_assert(RelativePoses::kMost % kDoubles == 0);
  found.apart = 0;
  for (std::size_t first = 0; first < count; first += kDoubles) {
    std::array<const Pose*, kDoubles> here;
    for (std::size_t k = 0; k < kDoubles; ++k) {
      here[k] = poses[std::min(first + k, count - 1)];
    }
    const std::array<Real, 12> m = entries_of(here);
    std::array<Real, 9> matrix;
    std::array<Real, 3> shift;
    std::array<Real, 3> half_seen;
    std::array<Flag, 3> apart;
    const Real slack = find_relative(x, y, m, matrix, shift.data(), half_seen, apart);
    for (std::size_t i = 0; i < 9; ++i) {
      store(matrix[i], found.matrix[i], first);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      store(shift[i], found.shift[i], first);
      store(half_seen[i], found.half_seen[i], first);
    }
    found.apart |= bits(apart[0] | apart[1] | apart[2]) << first;
    find_boxes(box, shift, half_seen, slack, first, found);
  }
}
