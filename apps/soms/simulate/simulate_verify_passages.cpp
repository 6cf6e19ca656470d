#include "apps/soms/simulate/simulate_verify_passages.h"

#include "soms/base/parallel.h"
#include "soms/scene/passages.h"

#include "apps/soms/pairs/motion_verify.h"

#include <algorithm>
#include <limits>

namespace soms::command {

namespace {

/// Of each kind that are checked in a frame.
constexpr std::size_t kPassagesAFrame = 2;
constexpr std::size_t kFreePairsAFrame = 2;

/// The ways of two bodies to a frame.
class StepRoutes {
 public:
  StepRoutes(const World& world, const std::vector<Pose>& before, const std::vector<Pose>& poses)
      : world_(world), before_(before), poses_(poses) {}

  [[nodiscard]] VerifiedMotion with_city(MoverId mover, EnvironmentId part) const {
    const Body& city = world_.city[part];
    return {shape(mover), way(mover), city.shape, RigidMotion::along(city.pose, {})};
  }

  [[nodiscard]] VerifiedMotion between(MoverId a, MoverId b) const {
    return {shape(a), way(a), shape(b), way(b)};
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
};

template <class Passage>
bool is_wrong(const VerifiedMotion& ways, const Passage& passage) {
  FirstContact said{.verdict = passage.verdict, .t = passage.t};
  said.triangles = TrianglePair{passage.i, passage.j};
  return motion_difference(ways, said, {}).has_value();
}

bool is_wrongly_free(const VerifiedMotion& ways) {
  const FirstContact said{.t = {1, std::numeric_limits<double>::infinity()}};
  return motion_difference(ways, said, {}).has_value();
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
  const StepRoutes ways(world_, before, poses);
  VerifiedPassages verified;
  const std::size_t with_city = report.environment_passages.size();
  const std::size_t all = with_city + report.mover_passages.size();
  for (std::size_t k = 0; k < std::min(all, kPassagesAFrame); ++k) {
    check_stop(limits);
    const std::size_t at = rng_.below(all);
    ++verified.passages;
    if (at < with_city) {
      const EnvironmentPassage& passage = report.environment_passages[at];
      verified.wrong += is_wrong(ways.with_city(passage.mover, passage.part), passage) ? 1U : 0U;
    } else {
      const MoverPassage& passage = report.mover_passages[at - with_city];
      verified.wrong += is_wrong(ways.between(passage.a, passage.b), passage) ? 1U : 0U;
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
        verified.wrong += is_wrongly_free(ways.with_city(mover, part)) ? 1U : 0U;
      }
      continue;
    }
    const auto second = static_cast<MoverId>(other - world_.city.size());
    const auto [a, b] = std::minmax(mover, second);
    if (a != b && world_.filter.tests(a, b) && !lists_movers(report, a, b)) {
      ++verified.free;
      verified.wrong += is_wrongly_free(ways.between(a, b)) ? 1U : 0U;
    }
  }
  return verified;
}

}  // namespace soms::command
