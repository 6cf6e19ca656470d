// Checks of many poses, kDoubles at a time. Included inside a namespace, after relative_poses.h.
// What products lose that underflow, 2^-1075 each, is nothing beside the tolerance, 1 and 2^300.

/// Entry i,j of RtR.
inline Real gram(const std::array<Real, 12>& m, std::size_t i, std::size_t j) {
  return (m[i] * m[j] + m[4 + i] * m[4 + j]) + m[8 + i] * m[8 + j];
}

/// The sums of `passes_checks`, which allows the limits themselves, too. What is not a number is
/// within none.
inline Flag passes(const std::array<Real, 12>& m, const Vec3& far) {
  const Real tolerance(kRigidTolerance);
  Flag passes = tolerance > abs(gram(m, 0, 0) - Real(1));
  passes = passes & (tolerance > abs(gram(m, 1, 1) - Real(1)));
  passes = passes & (tolerance > abs(gram(m, 2, 2) - Real(1)));
  passes = passes & (tolerance > abs(gram(m, 0, 1)));
  passes = passes & (tolerance > abs(gram(m, 0, 2)));
  passes = passes & (tolerance > abs(gram(m, 1, 2)));
  const Real determinant =
      (m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8])) +
      m[2] * (m[4] * m[9] - m[5] * m[8]);
  passes = passes & (determinant > Real(0));
  for (std::size_t row = 0; row < 12; row += 4) {
    const Real reach = ((abs(m[row]) * Real(far.x) + abs(m[row + 1]) * Real(far.y)) +
                        abs(m[row + 2]) * Real(far.z)) +
                       abs(m[row + 3]);
    passes = passes & (Real(kMaxCoordinate) > reach);
  }
  return passes;
}

inline std::size_t passing_poses(const Pose* poses, std::size_t count, const Vec3& far) {
  for (std::size_t first = 0; first < count; first += kDoubles) {
    std::array<const Pose*, kDoubles> here;
    for (std::size_t k = 0; k < kDoubles; ++k) {
      here[k] = &poses[std::min(first + k, count - 1)];
    }
    const std::uint32_t failed = bits(passes(entries_of(here), far)) ^ ((1U << kDoubles) - 1);
    if (failed != 0) {
      return first + static_cast<std::size_t>(std::countr_zero(failed));
    }
  }
  return count;
}
