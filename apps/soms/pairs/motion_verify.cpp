#include "apps/soms/pairs/motion_verify.h"

#include "soms/motion/reference/first_contact.h"
#include "soms/query/reference/distance.h"
#include "soms/query/reference/overlap.h"

#include "apps/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace soms::command {

namespace {

/// Parts of the way at whose ends all pairs are compared.
constexpr int kStretches = 32;
/// Pairs of triangles that the law decides: some milliseconds each.
constexpr std::size_t kMostPairsByLaw = 4096;
/// Of the largest coordinate: what rounded poses are off.
constexpr double kSlackOfPoses = 0x1p-40;

double largest_coordinate(const Body& body) {
  double largest = 0;
  for (const Vec3& v : body.shape.mesh().vertices) {
    const Vec3 moved = body.pose.apply(v);
    largest = std::max({largest, std::abs(moved.x), std::abs(moved.y), std::abs(moved.z)});
  }
  return largest;
}

Shape one_triangle(const Shape& shape, TriangleId i) {
  const Triangle t = shape.mesh().triangle(i);
  Mesh mesh;
  mesh.vertices = {t.a, t.b, t.c};
  mesh.triangles = {{0, 1, 2}};
  return Shape(std::move(mesh));
}

/// An answer beside what brute force says at times of the way.
class MotionCheck {
 public:
  MotionCheck(const VerifiedMotion& motion, const FirstContact& answer,
              const FirstContactOptions& options, const Limits& limits)
      : motion_(motion), answer_(answer), options_(options), limits_(limits) {}

  [[nodiscard]] std::optional<std::string> difference() {
    if (options_.within == 0) {
      at_start_ = pairs_at(0);
    }
    const bool starts = touches_at(0);
    if (starts != (answer_.verdict == ContactVerdict::started) &&
        answer_.coverage == Coverage::complete) {
      return starts ? "brute force finds a contact at the start" : "no contact is at the start";
    }
    for (int k = 1; k <= kStretches; ++k) {
      check(limits_);
      const double t = static_cast<double>(k) / kStretches;
      if ((t < answer_.t.lower || answer_.t.lower == 1) && touches_before(t)) {
        return fmt::format("brute force finds a contact at t = {}, but none is said before {}",
                           readable(t), readable(answer_.t.lower));
      }
    }
    if (answer_.verdict == ContactVerdict::contact && !reaches()) {
      return fmt::format("the two triangles are apart at t = {}", readable(answer_.t.upper));
    }
    return by_law();
  }

 private:
  [[nodiscard]] Body a_at(double t) const { return Body(motion_.a, motion_.way_of_a.pose_at(t)); }

  [[nodiscard]] Body b_at(double t) const { return Body(motion_.b, motion_.way_of_b.pose_at(t)); }

  [[nodiscard]] bool rests() const {
    return motion_.way_of_b.straight() && motion_.way_of_b.by() == Vec3{};
  }

  [[nodiscard]] std::vector<TrianglePair> pairs_at(double t) const {
    const Body a = a_at(t);
    const Body b = b_at(t);
    return reference::overlap(a.shape.mesh(), a.pose, b.shape.mesh(), b.pose,
                              limits_.without_deadline())
        .pairs;
  }

  [[nodiscard]] bool touches_at(double t) const {
    return options_.within == 0
               ? !pairs_at(t).empty()
               : reference::within_by_brute_force(a_at(t), b_at(t), options_.within,
                                                  limits_.without_deadline());
  }

  /// Next to rounding, the law decides about a pair that touches at a pose.
  [[nodiscard]] bool touches_before(double t) const {
    if (options_.within > 0) {
      return touches_at(t);
    }
    const std::vector<TrianglePair> pairs = pairs_at(t);
    return std::any_of(pairs.begin(), pairs.end(), [&](const TrianglePair& pair) {
      return std::find(at_start_.begin(), at_start_.end(), pair) == at_start_.end() &&
             (!rests() || pair_by_law(pair).t.upper < answer_.t.lower);
    });
  }

  [[nodiscard]] FirstContact pair_by_law(const TrianglePair& pair) const {
    return reference::first_contact_by_brute_force(
        one_triangle(motion_.a, pair.a), motion_.way_of_a,
        Body(one_triangle(motion_.b, pair.b), motion_.way_of_b.start()));
  }

  /// The pair that is named is in contact at `t.upper`, but for the rounding of poses.
  [[nodiscard]] bool reaches() const {
    const Body a(one_triangle(motion_.a, answer_.triangles->a), a_at(answer_.t.upper).pose);
    const Body b(one_triangle(motion_.b, answer_.triangles->b), b_at(answer_.t.upper).pose);
    const double slack = kSlackOfPoses * std::max(largest_coordinate(a), largest_coordinate(b));
    return reference::within_by_brute_force(a, b, options_.within + slack);
  }

  [[nodiscard]] std::optional<std::string> by_law() const {
    const std::size_t pairs = motion_.a.mesh().triangles.size() * motion_.b.mesh().triangles.size();
    if (!rests() || options_ != FirstContactOptions{} || pairs > kMostPairsByLaw ||
        answer_.coverage == Coverage::cut) {
      return std::nullopt;
    }
    const FirstContact truth = reference::first_contact_by_brute_force(
        motion_.a, motion_.way_of_a, Body(motion_.b, motion_.way_of_b.start()));
    const bool free = truth.verdict == ContactVerdict::free;
    if (free != (answer_.verdict == ContactVerdict::free) &&
        truth.verdict != ContactVerdict::grazing) {
      return fmt::format("the law of the motion says {}", name(truth.verdict));
    }
    if (!free && answer_.t.lower > truth.t.upper) {
      return fmt::format("the law of the motion has a contact by t = {}, before {}",
                         readable(truth.t.upper), readable(answer_.t.lower));
    }
    return std::nullopt;
  }

  const VerifiedMotion& motion_;
  const FirstContact& answer_;
  const FirstContactOptions& options_;
  const Limits& limits_;
  std::vector<TrianglePair> at_start_;  ///< in contact; with `parting` they are left out
};

}  // namespace

std::optional<std::string> motion_difference(const VerifiedMotion& motion,
                                             const FirstContact& answer,
                                             const FirstContactOptions& options,
                                             const Limits& limits) {
  return MotionCheck(motion, answer, options, limits).difference();
}

}  // namespace soms::command
