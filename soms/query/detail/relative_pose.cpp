#include "soms/query/detail/relative_pose.h"

#include "soms/base/double_limits.h"
#include "soms/query/detail/engine/rounded.h"
#include "soms/query/detail/query_lanes.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

// Constants of the proof in relative_pose.h, and its addends. "Largest seen" is the most that tests
// and tests/query/margins/margin_search.cpp ever needed of one. What is left over was never met;
// that it cannot be is not claimed.

/// Errors of a product of three and of a moved coordinate, and of a coordinate's place about its
/// tree's origin.
constexpr double kOfProduct = 3.01;
constexpr double kOfMoved = 4.01;
constexpr double kReach = 3.47;
constexpr double kRowOfInverse = 1.74;

/// kSlackOfRounding is W's rounding, in units of u64 V. Largest seen: 0.023 of W (4.5 u64 V), and
/// 0.013 of the 2 W that roots give way by (4.9 u64 V).
constexpr double kSumOfRounding =
    3 * kOfProduct * kReach                               // N
    + (2 * kOfMoved + 1.01 + kOfProduct) * kRowOfInverse  // D
    + 3 * kOfProduct * kReach                             // measuring the residual
    + kRowOfInverse * kOfMoved                            // X e
    + (kOfProduct * kRowOfInverse * kReach + 2 * 11.3)    // offsets of nodes
    + 4 * 10                                              // the roots' test
    + (kRowOfInverse + 1) * kReach;                       // corners of blocks
static_assert(kSumOfRounding <= 184 && 184 <= kSlackOfRounding);

/// kSlackOfResidual is W's share of the residual, in units of V. No answer needs it: `inverse_of`
/// leaves a residual of a few u64, for which kSlackOfRounding has room. Largest seen with a worse
/// inverse: 0.125 of it.
static_assert(3 * kReach <= 10.5 && 10.5 <= kSlackOfResidual);

/// The margin for floats, in units of S. Largest seen: 0.033 of it, defects included.
constexpr double kMarginOfFloats = 0x1p-17;
constexpr double kSumOfFloats = 28 * kRowOfInverse    // the gap between centers, turned
                                + 13 * kRowOfInverse  // the turn itself
                                + 13 + 8 + 7;         // radii, M^T M - I, comparisons
static_assert(10 + 7 + 4 + 2 + 5 <= 28);              // M, d, corners, Q_y^T Q_y, products and sums
static_assert(kSumOfFloats <= 100 && 100 * 0x1p-24 <= kMarginOfFloats);

/// The margin for axes that are not quite at right angles, in units of the defect and S: once along
/// x's axes, three times for d seen in them. No answer was found that needs it: poses are
/// orthonormal to 1e-6, so the defect is at most 2.1e-6, a fourth of kMarginOfFloats, of which
/// floats were never seen to take so much that as little was left.
constexpr double kMarginOfDefect = 4;
static_assert(1 + 3 <= kMarginOfDefect);

/// S in units of radius_x + radius_y, sqrt(3) being below 1.73206.
constexpr double kSumOfRadii = 2.75;
static_assert(1 + 1.73206 * (1 + 1e-5) <= 2.733 && 2.733 <= kSumOfRadii);

/// What lengths of gaps are shortened by to be lower bounds (near/near_pose.h): the axes of two
/// nodes and eight roundings, and N, by its defect. Largest seen of the second: 0.75, where entries
/// of R are all off by as much. Answers need neither beside what limits grant (near_pose.cpp).
constexpr double kLengthsOfFloats = 0x1p-19;
constexpr double kLengthsOfDefect = 2;
static_assert(0x1p-21 + 0x1p-21 <= kLengthsOfFloats && 1.5 <= kLengthsOfDefect);

constexpr Matrix3 kIdentity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Matrix3 product(const Matrix3& a, const Matrix3& b) {
  Matrix3 c = {};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      c[i][j] = (a[i][0] * b[0][j] + a[i][1] * b[1][j]) + a[i][2] * b[2][j];
    }
  }
  return c;
}

/// Adjugate over determinant; for rotations to 1e-6 good to a few units in the last place.
Matrix3 inverse_of(const Matrix3& r) {
  Matrix3 adjugate = {};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t i1 = (i + 1) % 3;
      const std::size_t i2 = (i + 2) % 3;
      const std::size_t j1 = (j + 1) % 3;
      const std::size_t j2 = (j + 2) % 3;
      adjugate[j][i] = r[i1][j1] * r[i2][j2] - r[i1][j2] * r[i2][j1];
    }
  }
  const double det =
      (r[0][0] * adjugate[0][0] + r[0][1] * adjugate[1][0]) + r[0][2] * adjugate[2][0];
  for (auto& row : adjugate) {
    for (double& entry : row) {
      entry /= det;
    }
  }
  return adjugate;
}

double distance_from_identity(const Matrix3& m) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      most = std::max(most, std::abs(m[i][j] - (i == j ? 1 : 0)));
    }
  }
  return most;
}

/// Distance of M^T M, which is symmetric, from the identity, for the rows of M.
double defect_of(const std::array<double, 9>& m) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const double sum = (m[i] * m[j] + m[3 + i] * m[3 + j]) + m[6 + i] * m[6 + j];
      most = std::max(most, std::abs(sum - (i == j ? 1 : 0)));
    }
  }
  return most;
}

/// `Pose::apply`, close at hand.
Vec3 moved(const Pose& pose, const Vec3& v) {
  const auto& m = pose.m;
  return {((m[0] * v.x + m[1] * v.y) + m[2] * v.z) + m[3],
          ((m[4] * v.x + m[5] * v.y) + m[6] * v.z) + m[7],
          ((m[8] * v.x + m[9] * v.y) + m[10] * v.z) + m[11]};
}

/// Of a box whose origin is its center; the half sides, rounded up, reach both ends.
MovedNumbers numbers_of_box(const Box& box) {
  MovedNumbers numbers{box.center(), farthest(box), {}};
  for (std::size_t k = 0; k < 3; ++k) {
    const double half =
        std::max(box.upper[k] - numbers.origin[k], numbers.origin[k] - box.lower[k]);
    numbers.half[k] = std::nextafter(half, kInfinity);
  }
  return numbers;
}

using Real = double;
using Flag = bool;
using std::abs;
using std::max;

#include "soms/query/detail/kernels/relative.h"

}  // namespace

Vec3 farthest(const Box& box) {
  return {std::max(std::abs(box.lower.x), std::abs(box.upper.x)),
          std::max(std::abs(box.lower.y), std::abs(box.upper.y)),
          std::max(std::abs(box.lower.z), std::abs(box.upper.z))};
}

double moved_extent(const Pose& pose, const Box& box) {
  const Vec3 far = farthest(box);
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double sum = ((std::abs(pose.m[4 * k + 3]) + std::abs(pose.m[4 * k]) * far[0]) +
                        std::abs(pose.m[4 * k + 1]) * far[1]) +
                       std::abs(pose.m[4 * k + 2]) * far[2];
    most = std::max(most, sum);
  }
  return most;
}

Matrix3 rotation(const Pose& pose) {
  const auto& m = pose.m;
  return {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}};
}

ReferenceFrame::ReferenceFrame(const WideTree& t, const Pose& p) : tree(&t) {
  inverse = rotation(p);
  origin = moved(p, t.origin());
  half = t.bounds().extent() * 0.5;
  extent = moved_extent(p, t.bounds());
  rotated = inverse != kIdentity;
  if (rotated) {
    inverse = inverse_of(rotation(p));
    residual = distance_from_identity(product(inverse, rotation(p)));
  }
}

MovedNumbers moved_numbers(const WideTree& tree) {
  return {tree.origin(), farthest(tree.bounds()), tree.bounds().extent() * 0.5};
}

RelativePose::RelativePose(const WideTree& x, const Pose& pose_x, const ReferenceFrame& y)
    : RelativePose(moved_numbers(x), pose_x, y, y.tree->exponent() - x.exponent()) {
}

RelativePose::RelativePose(const Box& x, const ReferenceFrame& y)
    : RelativePose(numbers_of_box(x), Pose(), y, 0) {
}

RelativePose::RelativePose(const MovedNumbers& x, const Pose& pose_x, const ReferenceFrame& y,
                           int exponents)
    : residual_(y.residual), exponents_(exponents) {
  std::array<bool, 3> apart;
  const double slack =
      find_relative(x, y, pose_x.m, matrix_, numbers_.shift.data(), half_seen_, apart);
  apart_ = (static_cast<unsigned>(apart[0]) | static_cast<unsigned>(apart[1]) |
            static_cast<unsigned>(apart[2])) != 0;
  numbers_.scale = y.tree->scale();
  if (slack * numbers_.scale <= kMostSlackOfPoses) {
    numbers_.slack = rounded_up(slack * numbers_.scale + kSlackOfLengths);
  } else {
    // Every box meets every other.
    numbers_.slack = 0x1p100F;
    numbers_.scale = 0;
  }
  numbers_.rounding = numbers_.slack;
}

RelativePose::RelativePose(const WideTree& x, const WideTree& y, const RelativePoses& poses,
                           std::size_t i)
    : residual_(poses.residual[i]),
      exponents_(y.exponent() - x.exponent()),
      apart_((poses.apart >> i & 1U) != 0) {
  for (std::size_t k = 0; k < 9; ++k) {
    matrix_[k] = poses.matrix[k][i];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    numbers_.shift[k] = poses.shift[k][i];
    half_seen_[k] = poses.half_seen[k][i];
  }
  numbers_.scale = poses.scale[i];
  numbers_.slack = poses.slack[i];
  numbers_.rounding = poses.slack[i];
}

void RelativePose::put(RelativePoses& poses, std::size_t i, const SingleBox& box) const {
  for (std::size_t k = 0; k < 9; ++k) {
    poses.matrix[k][i] = matrix_[k];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    poses.shift[k][i] = numbers_.shift[k];
    poses.half_seen[k][i] = half_seen_[k];
    poses.half[k][i] = box.half[k];
  }
  poses.scale[i] = numbers_.scale;
  poses.slack[i] = numbers_.slack;
  poses.residual[i] = residual_;
  poses.sum[i] = box.sum;
  for (std::size_t k = 0; k < 2; ++k) {
    poses.from[k][i] = box.place.from[k];
    poses.to[k][i] = box.place.to[k];
  }
  poses.lower[i] = box.place.lower;
  poses.upper[i] = box.place.upper;
  poses.apart |= (apart_ ? 1U : 0U) << i;
}

void RelativePose::prepare() {
  const auto& m = matrix_;
  for (std::size_t i = 0; i < 3; ++i) {
    const F4 row = {static_cast<float>(m[3 * i]), static_cast<float>(m[3 * i + 1]),
                    static_cast<float>(m[3 * i + 2]), 0};
    const F4 column = {static_cast<float>(m[i]), static_cast<float>(m[3 + i]),
                       static_cast<float>(m[6 + i]), 0};
    store(row, numbers_.rows, 4 * i);
    store(abs(row), numbers_.magnitudes, 4 * i);
    store(column, numbers_.columns, 4 * i);
    store(row, turn_.entry[i], 0);
    store(abs(row), turn_.magnitude[i], 0);
    numbers_.column[i] = {m[i], m[3 + i], m[6 + i], 0};
  }
  for (std::array<float, 16>* rows : {&numbers_.rows, &numbers_.magnitudes, &numbers_.columns}) {
    store(F4{}, *rows, 12);
  }
  const double defect = defect_of(m);
  numbers_.relative = rounded_up(kSumOfRadii * (kMarginOfFloats + kMarginOfDefect * defect));
  numbers_.shrink = static_cast<float>(1 - (kLengthsOfFloats + kLengthsOfDefect * defect));
  numbers_.ratio = exponents_ == 0 ? 1 : static_cast<float>(std::ldexp(1.0, exponents_));
}

void RelativePose::single_box(SingleBox& box) const {
  box.scale = numbers_.scale;
  box.slack = numbers_.slack;
  for (std::size_t i = 0; i < 3; ++i) {
    box.center[i] = numbers_.shift[i];
    box.half[i] = static_cast<float>(half_seen_[i] * box.scale);
  }
  box.size = std::max({box.half[0], box.half[1], box.half[2]});
  box.sum = (box.half[0] + box.half[1]) + box.half[2];
}

void RelativePose::turn(const layout::Axes& x, const layout::Axes& y, BoxRelation& relation) const {
  const F4 x0 = {x[0], x[1], x[2], 0};
  const F4 x1 = {x[3], x[4], x[5], 0};
  const F4 x2 = {x[6], x[7], x[8], 0};
  // The offset rides in the fourth lane.
  std::array<F4, 3> row;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& n = turn_.entry[i];
    row[i] = ((x0 * n[0] + x1 * n[1]) + x2 * n[2]) + F4{0, 0, 0, relation.offset[i]};
  }
  relation.turn = &relation.own;
  for (std::size_t i = 0; i < 3; ++i) {
    const F4 seen = (row[0] * y[i] + row[1] * y[3 + i]) + row[2] * y[6 + i];
    relation.offset[i] = seen[3];
    store(seen, relation.own.entry[i], 0);
    store(abs(seen), relation.own.magnitude[i], 0);
  }
}

}  // namespace soms::detail
