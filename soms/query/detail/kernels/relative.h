// N, D and the slack of relative_pose.h, of one pose of x or of several side by side. Included
// inside a namespace, after `Real`, a double or lanes of them, and `Flag`, what comparing them
// gives; with `abs` and `max`. A product that underflows loses 2^-1075, and is then multiplied by
// an entry of the inverse at most: below 2^-1070 on an axis, kSlackOfUnderflow has 2^-1064 for it.

inline Real row_times(const std::array<double, 3>& a, const Real& x, const Real& y, const Real& z) {
  return (Real(a[0]) * x + Real(a[1]) * y) + Real(a[2]) * z;
}

/// \param m         the pose of x, as in Pose
/// \param matrix    rows of N
/// \param shift     D
/// \param half_seen half sides of x's bounds along y's axes
/// \param apart     for each of these axes: the bounds are surely apart
/// \return 2 W, in the mesh's units
inline Real find_relative(const MovedNumbers& x, const ReferenceNumbers& y,
                          const std::array<Real, 12>& m, std::array<Real, 9>& matrix, Real* shift,
                          std::array<Real, 3>& half_seen, std::array<Flag, 3>& apart) {
  std::array<Real, 3> between;
  Real most(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Real* const row = &m[4 * i];
    between[i] =
        (((row[0] * Real(x.origin.x) + row[1] * Real(x.origin.y)) + row[2] * Real(x.origin.z)) +
         row[3]) -
        Real(y.origin[i]);
    most = max(most, ((abs(row[3]) + abs(row[0]) * Real(x.far.x)) + abs(row[1]) * Real(x.far.y)) +
                         abs(row[2]) * Real(x.far.z));
  }
  const double slack_a_unit = kSlackOfRounding * kRoundingUnit + kSlackOfResidual * y.residual;
  const Real slack =
      Real(2) * (Real(slack_a_unit) * (Real(y.extent) + most) + Real(kSlackOfUnderflow));
  for (std::size_t i = 0; i < 3; ++i) {
    Real* const row = &matrix[3 * i];
    if (y.rotated) {
      for (std::size_t j = 0; j < 3; ++j) {
        row[j] = row_times(y.inverse[i], m[j], m[4 + j], m[8 + j]);
      }
      shift[i] = row_times(y.inverse[i], between[0], between[1], between[2]);
    } else {
      for (std::size_t j = 0; j < 3; ++j) {
        row[j] = m[4 * i + j];
      }
      shift[i] = between[i];
    }
    half_seen[i] = (abs(row[0]) * Real(x.half.x) + abs(row[1]) * Real(x.half.y)) +
                   abs(row[2]) * Real(x.half.z);
    apart[i] = abs(shift[i]) > (half_seen[i] + Real(y.half[i])) + slack;
  }
  return slack;
}
