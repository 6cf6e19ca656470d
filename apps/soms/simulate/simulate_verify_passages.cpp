#include "apps/soms/simulate/simulate_verify_passages.h"

#include "soms/base/parallel.h"
#include "soms/scene/passages.h"

#include "apps/soms/pairs/motion_verify.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace soms::command {

namespace {

/// Of each kind that are checked in a frame.
constexpr std::size_t kPassagesAFrame = 2;
constexpr std::size_t kFreePairsAFrame = 2;

/// Holds a body on its way: its pivot goes straight, and no corner is farther from it than in the
/// shape. Some 1e-9 are for rounding.
Box box_of_way(const Shape& shape, const RigidMotion& way) {
  const Box& own = shape.bounds();
  Vec3 farthest;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    farthest[axis] = std::max(std::abs(own.lower[axis] - way.pivot()[axis]),
                              std::abs(own.upper[axis] - way.pivot()[axis]));
  }
  Box box;
  box.grow(way.pivot_from());
  box.grow(way.pivot_to());
  const double reach = std::sqrt(dot(farthest, farthest));
  const double largest = std::sqrt(std::max(dot(box.lower, box.lower), dot(box.upper, box.upper)));
  const double margin = reach + 1e-9 * (reach + largest);
  box.lower = box.lower - Vec3{margin, margin, margin};
  box.upper = box.upper + Vec3{margin, margin, margin};
  return box;
}

/// The triangles of a body whose boxes meet another one, in the coordinates of the body.
struct NearWay {
  Mesh mesh;
  std::vector<TriangleId> triangles;

  NearWay(const Body& body, const Box& box) {
    const MeshView& whole = body.shape.mesh();
    for (TriangleId j = 0; j < whole.triangles.size(); ++j) {
      const Triangle t = whole.triangle(j);
      Box moved;
      for (const Vec3& corner : {t.a, t.b, t.c}) {
        moved.grow(body.pose.apply(corner));
      }
      if (overlaps(moved, box)) {
        const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {t.a, t.b, t.c});
        mesh.triangles.push_back({next, next + 1, next + 2});
        triangles.push_back(j);
      }
    }
  }
};

/// The ways of two bodies to a frame, and what brute force finds wrong with an answer.
class StepRoutes {
 public:
  StepRoutes(const World& world, const std::vector<Pose>& before, const std::vector<Pose>& poses,
             const Limits& limits)
      : world_(world), before_(before), poses_(poses), limits_(limits.without_deadline()) {}

  [[nodiscard]] bool is_wrong_with_city(MoverId mover, EnvironmentId part,
                                        FirstContact said) const {
    const Body& city = world_.city[part];
    const RigidMotion route = way(mover);
    const NearWay near(city, box_of_way(shape(mover), route));
    if (said.triangles) {
      const auto at =
          std::lower_bound(near.triangles.begin(), near.triangles.end(), said.triangles->b);
      if (at == near.triangles.end() || *at != said.triangles->b) {
        return true;  // it is far from the way
      }
      said.triangles->b = static_cast<TriangleId>(at - near.triangles.begin());
    }
    return !near.triangles.empty() && motion_difference({shape(mover), route, Shape(near.mesh),
                                                         RigidMotion::along(city.pose, {})},
                                                        said, {}, limits_)
                                          .has_value();
  }

  [[nodiscard]] bool is_wrong_between(MoverId a, MoverId b, const FirstContact& said) const {
    if (!overlaps(box_of_way(shape(a), way(a)), box_of_way(shape(b), way(b)))) {
      return said.verdict != ContactVerdict::free;
    }
    return motion_difference({shape(a), way(a), shape(b), way(b)}, said, {}, limits_).has_value();
  }

 private:
  [[nodiscard]] const Shape& shape(MoverId mover) const {
    return world_.models[world_.routes[mover].model].shape;
  }

  [[nodiscard]] RigidMotion way(MoverId mover) const {
    return way_of_step(shape(mover), before_[mover], poses_[mover]);
  }

  const World& world_;
  const std::vector<Pose>& before_;
  const std::vector<Pose>& poses_;
  Limits limits_;  ///< a frame is checked as a whole
};

template <class Passage>
FirstContact said_of(const Passage& passage) {
  FirstContact said{.verdict = passage.verdict, .t = passage.t};
  said.triangles = TrianglePair{passage.i, passage.j};
  return said;
}

FirstContact said_free() {
  return {.t = {1, std::numeric_limits<double>::infinity()}};
}

/// The two are in the list, which names bodies as `first` and `second` of its entries.
template <class Entry>
bool names(const std::vector<Entry>& list, std::uint32_t a, std::uint32_t b,
           std::uint32_t Entry::*first, std::uint32_t Entry::*second) {
  return std::any_of(list.begin(), list.end(),
                     [&](const Entry& entry) { return entry.*first == a && entry.*second == b; });
}

bool lists(const StepReport& report, MoverId mover, EnvironmentId part) {
  return names(report.environment, mover, part, &EnvironmentContact::mover,
               &EnvironmentContact::part) ||
         names(report.environment_passages, mover, part, &EnvironmentPassage::mover,
               &EnvironmentPassage::part);
}

bool lists_movers(const StepReport& report, MoverId a, MoverId b) {
  return names(report.movers, a, b, &MoverContact::a, &MoverContact::b) ||
         names(report.mover_passages, a, b, &MoverPassage::a, &MoverPassage::b);
}

}  // namespace

VerifiedPassages PassageVerifier::verify(const StepReport& report, const std::vector<Pose>& before,
                                         const std::vector<Pose>& poses, const Limits& limits) {
  const StepRoutes ways(world_, before, poses, limits);
  VerifiedPassages verified;
  const std::size_t with_city = report.environment_passages.size();
  const std::size_t all = with_city + report.mover_passages.size();
  for (std::size_t k = 0; k < std::min(all, kPassagesAFrame); ++k) {
    check_stop(limits);
    const std::size_t at = rng_.below(all);
    ++verified.passages;
    if (at < with_city) {
      const EnvironmentPassage& passage = report.environment_passages[at];
      verified.wrong +=
          ways.is_wrong_with_city(passage.mover, passage.part, said_of(passage)) ? 1U : 0U;
    } else {
      const MoverPassage& passage = report.mover_passages[at - with_city];
      verified.wrong += ways.is_wrong_between(passage.a, passage.b, said_of(passage)) ? 1U : 0U;
    }
  }
  for (std::size_t k = 0; k < kFreePairsAFrame && !poses.empty(); ++k) {
    check_stop(limits);
    const auto mover = static_cast<MoverId>(rng_.below(poses.size()));
    const std::size_t other = rng_.below(world_.city.size() + poses.size());
    if (other < world_.city.size()) {
      const auto part = static_cast<EnvironmentId>(other);
      if (!lists(report, mover, part)) {
        ++verified.free;
        verified.wrong += ways.is_wrong_with_city(mover, part, said_free()) ? 1U : 0U;
      }
      continue;
    }
    const auto second = static_cast<MoverId>(other - world_.city.size());
    const auto [a, b] = std::minmax(mover, second);
    if (a != b && world_.filter.tests(a, b) && !lists_movers(report, a, b)) {
      ++verified.free;
      verified.wrong += ways.is_wrong_between(a, b, said_free()) ? 1U : 0U;
    }
  }
  return verified;
}

}  // namespace soms::command
