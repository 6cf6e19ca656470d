#include "bench/peers/core/solid_judge.h"

#include "soms/query/solid.h"

#include <algorithm>
#include <array>

namespace soms::bench {

namespace {

constexpr double number_of(Relation relation) {
  return static_cast<double>(relation);
}

static_assert(SolidJudge::kTouching == number_of(Relation::touching));

/// A point of the world in the frame of a body at `pose`, up to rounding.
Vec3 taken_back(const Pose& pose, const Vec3& p) {
  const Vec3 q = p - pose.shift();
  const auto& m = pose.m;
  return {m[0] * q.x + m[4] * q.y + m[8] * q.z, m[1] * q.x + m[5] * q.y + m[9] * q.z,
          m[2] * q.x + m[6] * q.y + m[10] * q.z};
}

/// Whether corners were seen inside and outside of the other body.
struct Sides {
  bool inside = false;
  bool outside = false;

  void add(double side) {
    inside = inside || side == 1;
    outside = outside || side == 0;
  }

  [[nodiscard]] bool both() const { return inside && outside; }
};

}  // namespace

SolidJudge::SolidJudge(const FloatMesh& mover, const FloatMesh& fixed)
    : mover_(mover), fixed_(fixed), pairs_(mover, fixed), of_mover_(mover), of_fixed_(fixed) {
}

double SolidJudge::relation(const Pose& pose) const {
  const auto side_of_mover = [&](const Vec3& p) { return of_fixed_.side(pose.apply(p)); };
  const auto side_of_fixed = [&](const Vec3& p) { return of_mover_.side(taken_back(pose, p)); };
  const std::vector<PairCounter::Pair> pairs = pairs_.pairs(pose);
  if (pairs.empty()) {
    if (side_of_mover(mover_.triangle(0).a) == 1) {
      return number_of(Relation::a_in_b);
    }
    return number_of(side_of_fixed(fixed_.triangle(0).a) == 1 ? Relation::b_in_a : Relation::clear);
  }
  Sides mover;
  Sides fixed;
  for (const auto& [i, k] : pairs) {
    const Triangle s = mover_.triangle(i);
    const Triangle t = fixed_.triangle(k);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      mover.add(side_of_mover(std::array{s.a, s.b, s.c}[corner]));
      fixed.add(side_of_fixed(std::array{t.a, t.b, t.c}[corner]));
    }
    if (mover.both() || fixed.both()) {
      return number_of(Relation::crossing);
    }
  }
  return kTouching;
}

}  // namespace soms::bench
