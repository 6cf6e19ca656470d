#include "soms/base/pose.h"

#include "soms/base/arithmetic.h"
#include "soms/base/decimal.h"
#include "soms/base/error.h"
#include "soms/base/text.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

namespace soms {

namespace {

/// How far entries of RtR - I may be off 0, and that in words.
struct RigidLimit {
  double value;
  const char* text;
};

constexpr RigidLimit kRigid{kRigidTolerance, "1e-6"};
constexpr RigidLimit kNearlyRigid{1e-3, "1e-3"};  // of what is made a rotation

std::string entry_name(int row, int column) {
  if (column == 3) {
    return std::string("t") + "xyz"[row];
  }
  return "r" + std::to_string(row) + std::to_string(column);
}

void check_finite(const Pose& pose) {
  for (int i = 0; i < 12; ++i) {
    if (!std::isfinite(pose.m[static_cast<std::size_t>(i)])) {
      throw Error(ErrorKind::not_finite,
                  "pose: entry " + entry_name(i / 4, i % 4) + " is not a finite number",
                  "give twelve finite numbers");
    }
  }
}

/// Entry i,j of RtR.
double gram(const Pose& pose, std::size_t i, std::size_t j) {
  const auto& m = pose.m;
  return (m[i] * m[j] + m[4 + i] * m[4 + j]) + m[8 + i] * m[8 + j];
}

double determinant(const Pose& pose) {
  const auto& m = pose.m;
  return (m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8])) +
         m[2] * (m[4] * m[9] - m[5] * m[8]);
}

/// Entries of RtR - I, which is symmetric: the diagonal, and those above it.
std::array<double, 6> off_rigid(const Pose& pose) {
  return {gram(pose, 0, 0) - 1, gram(pose, 1, 1) - 1, gram(pose, 2, 2) - 1,
          gram(pose, 0, 1),     gram(pose, 0, 2),     gram(pose, 1, 2)};
}

/// The greatest magnitude of six numbers.
double greatest(const std::array<double, 6>& off) {
  return std::max(std::max(std::max(std::abs(off[0]), std::abs(off[1])), std::abs(off[2])),
                  std::max(std::max(std::abs(off[3]), std::abs(off[4])), std::abs(off[5])));
}

/// What `require_rigid` asks, without branches and without saying what is wrong.
bool is_rigid(const Pose& pose) {
  const auto& m = pose.m;
  const std::array<double, 6> off = off_rigid(pose);
  const double most = greatest(off);
  // Not a number where any entry is not finite; `most` may have lost it.
  const double sum = (((off[0] + off[1]) + (off[2] + off[3])) + (off[4] + off[5])) +
                     ((m[3] * 0 + m[7] * 0) + m[11] * 0);
  const unsigned near = most <= kRigidTolerance ? 1U : 0U;
  return (near & (sum == sum ? 1U : 0U) & (determinant(pose) > 0 ? 1U : 0U)) != 0;
}

/// What a moved vertex of a mesh with bounds `box` may reach on each axis.
std::array<double, 3> reach_of(const Pose& pose, const Box& box) {
  const std::array<double, 3> far = {std::max(std::abs(box.lower.x), std::abs(box.upper.x)),
                                     std::max(std::abs(box.lower.y), std::abs(box.upper.y)),
                                     std::max(std::abs(box.lower.z), std::abs(box.upper.z))};
  std::array<double, 3> reach;
  for (std::size_t row = 0; row < 3; ++row) {
    reach[row] = std::abs(pose.m[4 * row]) * far[0] + std::abs(pose.m[4 * row + 1]) * far[1] +
                 std::abs(pose.m[4 * row + 2]) * far[2] + std::abs(pose.m[4 * row + 3]);
  }
  return reach;
}

/// What to do about a matrix with another length of its columns, or another angle between them;
/// `off` is the greatest magnitude in RtR - I.
std::string remedy_for(const Pose& pose, double off) {
  if (off <= kNearlyRigid.value) {
    return "print the rotation with more digits, such as nine after the point (%.9f); in C++, "
           "Rotation::nearest corrects a rounded matrix, and Pose::normalized a product";
  }
  constexpr double kAlike = 1e-3;
  const double square = (gram(pose, 0, 0) + gram(pose, 1, 1) + gram(pose, 2, 2)) / 3;
  bool scales = square > 0 && std::isfinite(square) && std::abs(square - 1) > kAlike;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      scales = scales && std::abs(gram(pose, i, j) - (i == j ? square : 0)) <= kAlike * square;
    }
  }
  if (!scales) {
    return "give a rotation in seven digits or more, and scale the mesh instead";
  }
  std::array<char, 32> text;
  char* const end = write_significant(text.data(), text.data() + text.size(), std::sqrt(square), 6);
  return "the matrix scales by " + std::string(text.data(), end) +
         ": divide its rotation by that, and scale the mesh instead";
}

/// Throws what is wrong with a pose that is off a rotation by more than `limit`, if anything is.
void require_rigid(const Pose& pose, const RigidLimit& limit) {
  check_finite(pose);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const double off = std::abs(gram(pose, i, j) - (i == j ? 1 : 0));
      if (!(off <= limit.value)) {
        throw Error(ErrorKind::not_rigid,
                    "pose: entry " + std::to_string(i) + "," + std::to_string(j) +
                        " of RtR - I is " + shortest(off) + ", above " + limit.text,
                    remedy_for(pose, greatest(off_rigid(pose))));
      }
    }
  }
  if (!(determinant(pose) > 0)) {
    throw Error(ErrorKind::not_rigid, "pose: the matrix mirrors (its determinant is not positive)",
                "give a rotation; mirror the mesh instead");
  }
}

/// Numbers of a row, as a message has them.
std::string in_a_row(double a, double b, double c, double d) {
  return shortest(a) + " " + shortest(b) + " " + shortest(c) + " " + shortest(d);
}

/// Throws unless the last row of a matrix is that of a motion; `other` makes a pose of a matrix
/// that is stored the other way.
void check_last_row(const std::array<double, 16>& m, std::string_view other) {
  if (m[12] == 0 && m[13] == 0 && m[14] == 0 && m[15] == 1) {
    return;
  }
  for (const double x : m) {
    if (!std::isfinite(x)) {
      throw Error(ErrorKind::not_finite, "pose: the 4x4 matrix has an entry that is not finite",
                  "give sixteen finite numbers");
    }
  }
  const std::string row = in_a_row(m[12], m[13], m[14], m[15]);
  if (m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1) {
    throw Error(ErrorKind::not_rigid,
                "pose: the last row of the 4x4 matrix is " + row + ", its last column 0 0 0 1",
                "the matrix is stored the other way: call Pose::" + std::string(other));
  }
  throw Error(ErrorKind::not_rigid,
              "pose: the last row of the 4x4 matrix is " + row + ", not 0 0 0 1",
              "give the matrix of a rotation and a shift, without projection or scale");
}

std::array<double, 16> transposed(std::span<const double, 16> m) {
  std::array<double, 16> result{};
  for (std::size_t i = 0; i < 16; ++i) {
    result[i] = m[4 * (i % 4) + i / 4];
  }
  return result;
}

/// The pose of a matrix row by row.
Pose from_matrix(const std::array<double, 16>& matrix, Rotation rotation, std::string_view other) {
  check_last_row(matrix, other);
  Pose pose;
  std::copy_n(matrix.begin(), pose.m.size(), pose.m.begin());
  if (rotation == Rotation::nearest) {
    return pose.normalized();
  }
  check(pose);
  return pose;
}

}  // namespace

Pose Pose::translation(double x, double y, double z) {
  Pose pose;
  pose.m[3] = x;
  pose.m[7] = y;
  pose.m[11] = z;
  return pose;
}

Pose Pose::from_quaternion(double w, double x, double y, double z, const Vec3& t) {
  const PlainArithmetic plain;
  const double norm = ((w * w + x * x) + y * y) + z * z;
  if (!std::isfinite(norm)) {
    throw Error(ErrorKind::not_finite, "pose: the quaternion has an entry that is not finite",
                "give four finite numbers");
  }
  if (std::abs(norm - 1) > kRigidTolerance) {
    throw Error(ErrorKind::not_rigid,
                "pose: the quaternion's squared length is " + shortest(norm) + ", not 1",
                "normalize the quaternion (qw qx qy qz), and write it with seven digits or more");
  }
  // Twice the inverse of the squared length instead of 2: a quaternion that is off length 1 by up
  // to the tolerance still gives a rotation to the last bits.
  const double s = 2 / norm;
  Pose pose;
  pose.m = {1 - s * (y * y + z * z), s * (x * y - w * z),     s * (x * z + w * y),     t.x,
            s * (x * y + w * z),     1 - s * (x * x + z * z), s * (y * z - w * x),     t.y,
            s * (x * z - w * y),     s * (y * z + w * x),     1 - s * (x * x + y * y), t.z};
  return pose;
}

Pose Pose::about_z(double angle, const Vec3& t) {
  const PlainArithmetic plain;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Pose pose;
  pose.m = {c, -s, 0, t.x, s, c, 0, t.y, 0, 0, 1, t.z};
  return pose;
}

Pose Pose::from_axis_angle(const Vec3& axis, double angle, const Vec3& t) {
  const PlainArithmetic plain;
  const double largest = std::max(std::max(std::abs(axis.x), std::abs(axis.y)), std::abs(axis.z));
  if (!std::isfinite(axis.x) || !std::isfinite(axis.y) || !std::isfinite(axis.z) ||
      !std::isfinite(angle)) {
    throw Error(ErrorKind::not_finite, "pose: the axis or the angle is not finite",
                "give finite numbers, the angle in radians");
  }
  if (largest == 0) {
    throw Error(ErrorKind::usage, "pose: the axis of rotation is 0 0 0, which is no direction",
                "give an axis of any other length, such as 0 0 1");
  }
  const int exponent = std::ilogb(largest);
  const Vec3 u{std::scalbn(axis.x, -exponent), std::scalbn(axis.y, -exponent),
               std::scalbn(axis.z, -exponent)};
  const double k = std::sin(angle / 2) / std::sqrt((u.x * u.x + u.y * u.y) + u.z * u.z);
  return from_quaternion(std::cos(angle / 2), k * u.x, k * u.y, k * u.z, t);
}

Pose Pose::from_row_major(std::span<const double, 16> matrix, Rotation rotation) {
  std::array<double, 16> rows{};
  std::copy(matrix.begin(), matrix.end(), rows.begin());
  return from_matrix(rows, rotation, "from_column_major");
}

Pose Pose::from_column_major(std::span<const double, 16> matrix, Rotation rotation) {
  return from_matrix(transposed(matrix), rotation, "from_row_major");
}

std::array<double, 16> Pose::to_row_major() const {
  std::array<double, 16> matrix{};
  std::copy(m.begin(), m.end(), matrix.begin());
  matrix[15] = 1;
  return matrix;
}

std::array<double, 16> Pose::to_column_major() const {
  return transposed(to_row_major());
}

Pose Pose::inverse() const {
  const PlainArithmetic plain;
  check(*this);
  const double det = determinant(*this);
  const auto entry = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return settled((m[a] * m[b] - m[c] * m[d]) / det);
  };
  Pose back;
  back.m = {entry(5, 10, 6, 9), entry(2, 9, 1, 10), entry(1, 6, 2, 5), 0,
            entry(6, 8, 4, 10), entry(0, 10, 2, 8), entry(2, 4, 0, 6), 0,
            entry(4, 9, 5, 8),  entry(1, 8, 0, 9),  entry(0, 5, 1, 4), 0};
  for (std::size_t i = 0; i < 12; i += 4) {
    const double moved = (back.m[i] * m[3] + back.m[i + 1] * m[7]) + back.m[i + 2] * m[11];
    back.m[i + 3] = settled(0 - moved);
  }
  return back;
}

Pose Pose::normalized() const {
  const PlainArithmetic plain;
  require_rigid(*this, kNearlyRigid);
  // A step leaves at most 3/4 of the square of the spectral norm of I - RtR, which starts at 3e-3
  // or less: 7e-6, then 4e-11, then 1e-21, which is below what rounding leaves.
  constexpr int kSteps = 3;
  Pose result = *this;
  for (int step = 0; step < kSteps; ++step) {
    const Pose before = result;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const auto change = [&](std::size_t k) {
          return before.m[4 * i + k] * ((k == j ? 1 : 0) - gram(before, k, j));
        };
        result.m[4 * i + j] =
            settled(before.m[4 * i + j] + ((change(0) + change(1)) + change(2)) / 2);
      }
    }
  }
  return result;
}

Vec3 Pose::apply(const Vec3& v) const {
  return {((m[0] * v.x + m[1] * v.y) + m[2] * v.z) + m[3],
          ((m[4] * v.x + m[5] * v.y) + m[6] * v.z) + m[7],
          ((m[8] * v.x + m[9] * v.y) + m[10] * v.z) + m[11]};
}

Pose operator*(const Pose& a, const Pose& b) {
  const PlainArithmetic plain;
  Pose product;
  for (std::size_t i = 0; i < 12; i += 4) {
    for (std::size_t j = 0; j < 3; ++j) {
      product.m[i + j] =
          settled((a.m[i] * b.m[j] + a.m[i + 1] * b.m[4 + j]) + a.m[i + 2] * b.m[8 + j]);
    }
  }
  const Vec3 t = a.apply(b.shift());
  product.m[3] = settled(t.x);
  product.m[7] = settled(t.y);
  product.m[11] = settled(t.z);
  return product;
}

void check(const Pose& pose) {
  const PlainArithmetic plain;
  if (!is_rigid(pose)) {
    require_rigid(pose, kRigid);
  }
}

void check_range(const Pose& pose, const Box& box) {
  const PlainArithmetic plain;
  if (box.empty()) {
    return;
  }
  const std::array<double, 3> reach = reach_of(pose, box);
  for (std::size_t row = 0; row < 3; ++row) {
    if (!(reach[row] <= kMaxCoordinate)) {
      throw Error(ErrorKind::out_of_range,
                  std::string("pose: a moved vertex may exceed 2^300 along ") + "xyz"[row],
                  "use coordinates of magnitude at most 2^300");
    }
  }
}

bool passes_checks(const Pose& pose, const Box& box) {
  const auto [x, y, z] = reach_of(pose, box);
  const unsigned in_range = (x <= kMaxCoordinate ? 1U : 0U) & (y <= kMaxCoordinate ? 1U : 0U) &
                            (z <= kMaxCoordinate ? 1U : 0U);
  // Bodies that do not move mostly have the identity.
  return (pose == Pose() || is_rigid(pose)) && (in_range != 0 || box.empty());
}

}  // namespace soms
