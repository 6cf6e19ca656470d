#include "soms/base/pose.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace soms {

namespace {

constexpr double kRigidTolerance = 1e-6;

std::string entry_name(int row, int column) {
  if (column == 3) {
    return std::string("t") + "xyz"[row];
  }
  return "r" + std::to_string(row) + std::to_string(column);
}

/// All digits that count: a number just above a bound must not look like the bound.
std::string in_digits(double x) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
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

/// What `check` asks, without branches and without saying what is wrong.
bool is_rigid(const Pose& pose) {
  const auto& m = pose.m;
  const auto gram = [&](std::size_t i, std::size_t j) {
    return m[i] * m[j] + m[4 + i] * m[4 + j] + m[8 + i] * m[8 + j];
  };
  const std::array<double, 6> off = {gram(0, 0) - 1, gram(1, 1) - 1, gram(2, 2) - 1,
                                     gram(0, 1),     gram(0, 2),     gram(1, 2)};
  const double most =
      std::max(std::max(std::max(std::abs(off[0]), std::abs(off[1])), std::abs(off[2])),
               std::max(std::max(std::abs(off[3]), std::abs(off[4])), std::abs(off[5])));
  // Not a number where any entry is not finite; `most` may have lost it.
  const double sum = (((off[0] + off[1]) + (off[2] + off[3])) + (off[4] + off[5])) +
                     ((m[3] * 0 + m[7] * 0) + m[11] * 0);
  const double det = m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
                     m[2] * (m[4] * m[9] - m[5] * m[8]);
  const unsigned near = most <= kRigidTolerance ? 1U : 0U;
  return (near & (sum == sum ? 1U : 0U) & (det > 0 ? 1U : 0U)) != 0;
}

/// Throws what is wrong with a pose that is not rigid.
[[noreturn]] void refuse(const Pose& pose) {
  check_finite(pose);
  const auto& m = pose.m;
  const auto at = [&](std::size_t row, std::size_t column) { return m[4 * row + column]; };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const double gram = at(0, i) * at(0, j) + at(1, i) * at(1, j) + at(2, i) * at(2, j);
      const double off = std::abs(gram - (i == j ? 1 : 0));
      if (!(off <= kRigidTolerance)) {
        throw Error(ErrorKind::not_rigid,
                    "pose: entry " + std::to_string(i) + "," + std::to_string(j) +
                        " of RtR - I is " + in_digits(off) + ", above 1e-6",
                    "give a rotation; scale belongs into the mesh (--scale)");
      }
    }
  }
  throw Error(ErrorKind::not_rigid, "pose: the matrix mirrors (its determinant is not positive)",
              "give a rotation; mirror the mesh instead");
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
                "pose: the quaternion's squared length is " + in_digits(norm) + ", not 1",
                "normalise the quaternion (qw qx qy qz)");
  }
  // Twice the inverse of the squared length instead of 2: a quaternion written with six digits is
  // off length 1 by less than the tolerance, and still gives a rotation to the last bits.
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

Vec3 Pose::apply(const Vec3& v) const {
  return {((m[0] * v.x + m[1] * v.y) + m[2] * v.z) + m[3],
          ((m[4] * v.x + m[5] * v.y) + m[6] * v.z) + m[7],
          ((m[8] * v.x + m[9] * v.y) + m[10] * v.z) + m[11]};
}

void check(const Pose& pose) {
  const PlainArithmetic plain;
  if (!is_rigid(pose)) {
    refuse(pose);
  }
}

void check_range(const Pose& pose, const Box& box) {
  const PlainArithmetic plain;
  if (box.empty()) {
    return;
  }
  const std::array<double, 3> far = {std::max(std::abs(box.lower.x), std::abs(box.upper.x)),
                                     std::max(std::abs(box.lower.y), std::abs(box.upper.y)),
                                     std::max(std::abs(box.lower.z), std::abs(box.upper.z))};
  for (std::size_t row = 0; row < 3; ++row) {
    const double most = std::abs(pose.m[4 * row]) * far[0] +
                        std::abs(pose.m[4 * row + 1]) * far[1] +
                        std::abs(pose.m[4 * row + 2]) * far[2] + std::abs(pose.m[4 * row + 3]);
    if (!(most <= kMaxCoordinate)) {
      throw Error(ErrorKind::out_of_range,
                  std::string("pose: a moved vertex may exceed 2^300 along ") + "xyz"[row],
                  "use coordinates of magnitude at most 2^300");
    }
  }
}

}  // namespace soms
