#include "soms/motion/reference/first_contact.h"

#include "soms/base/arithmetic.h"
#include "soms/base/double_limits.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/motion/detail/parting.h"
#include "soms/motion/reference/detail/dyadic.h"
#include "soms/query/reference/detail/moved_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace soms::reference {

namespace {

using detail::Cubic;
using detail::Dyadic;
using detail::DyadicVec;
using soms::detail::Corners;
using soms::detail::corners_of;

/// Times are halved as often as this, and as many stretches of one pair are looked at.
constexpr int kDepth = 44;
constexpr int kMostStretches = 3000;

using CubicVec = std::array<Cubic, 3>;
using MovingTriangle = std::array<CubicVec, 3>;

DyadicVec exactly(const Vec3& v) {
  return {Dyadic(v.x), Dyadic(v.y), Dyadic(v.z)};
}

DyadicVec operator-(const DyadicVec& a, const DyadicVec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Dyadic dot(const DyadicVec& a, const DyadicVec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

DyadicVec cross(const DyadicVec& a, const DyadicVec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The law, times the square of the quaternion's length.
class ExactLaw {
 public:
  explicit ExactLaw(const RigidMotion& motion) : motion_(motion) {
    if (motion.straight()) {
      squared_ = Cubic(Dyadic(1));
      return;
    }
    std::array<Cubic, 4> q;
    for (std::size_t k = 0; k < 4; ++k) {
      const Dyadic from(motion.from()[k]);
      q[k] = Cubic(from, Dyadic(motion.to()[k]) - from);
    }
    const auto& [w, x, y, z] = q;
    const Dyadic two(2);
    squared_ = w * w + x * x + y * y + z * z;
    rotation_[0] = {w * w + x * x - y * y - z * z, (x * y - w * z) * two, (x * z + w * y) * two};
    rotation_[1] = {(x * y + w * z) * two, w * w - x * x + y * y - z * z, (y * z - w * x) * two};
    rotation_[2] = {(x * z - w * y) * two, (y * z + w * x) * two, w * w - x * x - y * y + z * z};
  }

  [[nodiscard]] const Cubic& squared() const { return squared_; }

  [[nodiscard]] CubicVec corner(const Vec3& body) const {
    CubicVec place;
    if (motion_.straight()) {
      const DyadicVec start = exactly(motion_.start().apply(body));
      const DyadicVec by = exactly(motion_.by());
      for (std::size_t i = 0; i < 3; ++i) {
        place[i] = Cubic(start[i], by[i]);
      }
      return place;
    }
    const DyadicVec arm = exactly(body) - exactly(motion_.pivot());
    const DyadicVec from = exactly(motion_.pivot_from());
    const DyadicVec step = exactly(motion_.pivot_to()) - from;
    for (std::size_t i = 0; i < 3; ++i) {
      place[i] = squared_ * Cubic(from[i], step[i]);
      for (std::size_t j = 0; j < 3; ++j) {
        place[i] = place[i] + rotation_[i][j] * arm[j];
      }
    }
    return place;
  }

 private:
  const RigidMotion& motion_;
  Cubic squared_;
  std::array<CubicVec, 3> rotation_;
};

/// A closed segment and a closed triangle share a point, and the segment is not in its plane. What
/// is in a plane with the other is found by other edges, or not at all.
bool meets(const DyadicVec& p, const DyadicVec& q, const std::array<DyadicVec, 3>& t) {
  const auto volume = [](const DyadicVec& a, const DyadicVec& b, const DyadicVec& c,
                         const DyadicVec& d) { return dot(a - d, cross(b - d, c - d)).sign(); };
  const int at_p = volume(t[0], t[1], t[2], p);
  const int at_q = volume(t[0], t[1], t[2], q);
  if (at_p * at_q > 0 || (at_p == 0 && at_q == 0)) {
    return false;
  }
  const auto [least, most] =
      std::minmax({volume(t[0], t[1], p, q), volume(t[1], t[2], p, q), volume(t[2], t[0], p, q)});
  return !(least < 0 && most > 0);
}

/// One pair of triangles.
class ExactPairMotion {
 public:
  ExactPairMotion(const ExactLaw& law, const RigidMotion& motion, const MovingTriangle& moving,
                  const Triangle& body, const Triangle& resting)
      : law_(law),
        motion_(motion),
        moving_(moving),
        body_(corners_of(body)),
        resting_(corners_of(resting)) {}

  /// The first time, a multiple of 2^-kDepth, from which on it is not proved free; `until` if it is
  /// up to there.
  [[nodiscard]] double free_until(double from, double to, double until) {
    if (from >= until) {
      return until;
    }
    ++stretches_;
    if (free_on(from, to)) {
      return until;
    }
    if (to - from <= std::ldexp(1.0, -kDepth) || stretches_ > kMostStretches) {
      return from;
    }
    const double middle = from + (to - from) / 2;
    const double first = free_until(from, middle, until);
    return first < std::min(middle, until) ? first : free_until(middle, to, until);
  }

  /// In contact, but for what `meets` leaves out.
  [[nodiscard]] bool touches(double at) const {
    const Dyadic t(at);
    const Dyadic squared = law_.squared()(t);
    std::array<DyadicVec, 3> x;
    std::array<DyadicVec, 3> y;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        x[k][i] = moving_[k][i](t);
        y[k][i] = squared * Dyadic(resting_[k][i]);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (meets(x[k], x[(k + 1) % 3], y) || meets(y[k], y[(k + 1) % 3], x)) {
        return true;
      }
    }
    return false;
  }

 private:
  [[nodiscard]] bool free_on(double from, double to) const {
    const Pose middle = motion_.law_at(from + (to - from) / 2);
    Corners placed;
    for (std::size_t k = 0; k < 3; ++k) {
      placed[k] = middle.apply(body_[k]);
    }
    const soms::detail::Parting parting = soms::detail::parting_of(placed, resting_, 0);
    if (!(parting.gap > 0)) {
      return false;
    }
    // From here on nothing is rounded.
    const DyadicVec n = exactly(parting.direction);
    Dyadic top = dot(n, exactly(resting_[0]));
    for (std::size_t k = 1; k < 3; ++k) {
      const Dyadic next = dot(n, exactly(resting_[k]));
      top = top < next ? next : top;
    }
    for (const CubicVec& x : moving_) {
      const Cubic beyond = x[0] * n[0] + x[1] * n[1] + x[2] * n[2] - law_.squared() * top;
      if (!beyond.positive_on(Dyadic(from), Dyadic(to))) {
        return false;
      }
    }
    return true;
  }

  const ExactLaw& law_;
  const RigidMotion& motion_;
  const MovingTriangle& moving_;
  Corners body_;
  Corners resting_;
  int stretches_ = 0;
};

/// All pairs.
class ContactScan {
 public:
  ContactScan(const Shape& mover, const RigidMotion& motion, const Body& fixed)
      : law_(motion),
        motion_(motion),
        resting_(detail::moved_triangles(fixed.shape.mesh(), fixed.pose)),
        starting_(detail::moved_triangles(mover.mesh(), motion.start())) {
    for (std::size_t i = 0; i < mover.mesh().triangles.size(); ++i) {
      bodies_.push_back(mover.mesh().triangle(static_cast<TriangleId>(i)));
      const Triangle& t = bodies_.back();
      moving_.push_back({law_.corner(t.a), law_.corner(t.b), law_.corner(t.c)});
    }
  }

  [[nodiscard]] FirstContact scan(const Limits& limits) {
    FirstContact answer;
    answer.t = {1, soms::detail::kInfinity};
    if (started(answer)) {
      return answer;
    }
    double until = 2;  // the end belongs to the way
    for (std::size_t i = 0; i < moving_.size(); ++i) {
      for (std::size_t j = 0; j < resting_.size(); ++j) {
        check(limits);
        ++answer.cost.triangle_tests;
        const double first = pair(i, j).free_until(0, 1, until);
        if (first < until) {
          until = first;
          answer.triangles = ids(i, j);
        }
      }
    }
    if (answer.triangles) {
      answer.verdict = ContactVerdict::grazing;
      answer.t = {until, soms::detail::kInfinity};
      find_contact(answer);
    }
    return answer;
  }

 private:
  [[nodiscard]] static TrianglePair ids(std::size_t i, std::size_t j) {
    return {static_cast<TriangleId>(i), static_cast<TriangleId>(j)};
  }

  [[nodiscard]] ExactPairMotion pair(std::size_t i, std::size_t j) const {
    return {law_, motion_, moving_[i], bodies_[i], resting_[j]};
  }

  [[nodiscard]] bool started(FirstContact& answer) const {
    for (std::size_t i = 0; i < starting_.size(); ++i) {
      for (std::size_t j = 0; j < resting_.size(); ++j) {
        if (triangles_overlap(starting_[i], resting_[j])) {
          answer.verdict = ContactVerdict::started;
          answer.t = {0, 0};
          answer.triangles = ids(i, j);
          return true;
        }
      }
    }
    return false;
  }

  /// Looks for a contact soon after the last time that is proved free, and then ever later.
  void find_contact(FirstContact& answer) const {
    double step = 0;
    for (int k = 0; k <= kDepth + 3; ++k) {
      const double at = std::min(1.0, answer.t.lower + step);
      if (any_touches(at, answer)) {
        answer.verdict = ContactVerdict::contact;
        answer.t.upper = at;
        return;
      }
      step = std::ldexp(1.0, k - kDepth - 2);
    }
  }

  [[nodiscard]] bool any_touches(double at, FirstContact& answer) const {
    for (std::size_t i = 0; i < moving_.size(); ++i) {
      for (std::size_t j = 0; j < resting_.size(); ++j) {
        if (pair(i, j).touches(at)) {
          answer.triangles = ids(i, j);
          return true;
        }
      }
    }
    return false;
  }

  ExactLaw law_;
  const RigidMotion& motion_;
  std::vector<Triangle> resting_;
  std::vector<Triangle> starting_;
  std::vector<Triangle> bodies_;
  std::vector<MovingTriangle> moving_;
};

}  // namespace

FirstContact first_contact_by_brute_force(const Shape& mover, const RigidMotion& motion,
                                          const Body& fixed, const Limits& limits) {
  const PlainArithmetic plain;
  return ContactScan(mover, motion, fixed).scan(limits);
}

}  // namespace soms::reference
