#include "soms/scene/passages.h"

#include "soms/motion/detail/swept_bounds.h"

#include <algorithm>

namespace soms {

bool is_between_steps(const EnvironmentPassage& passage,
                      std::span<const EnvironmentContact> contacts) {
  const auto found = std::lower_bound(contacts.begin(), contacts.end(),
                                      EnvironmentContact{passage.mover, passage.part, 0, 0});
  return passage.verdict != ContactVerdict::started &&
         (found == contacts.end() || found->mover != passage.mover || found->part != passage.part);
}

bool is_between_steps(const MoverPassage& passage, std::span<const MoverContact> contacts) {
  const auto found =
      std::lower_bound(contacts.begin(), contacts.end(), MoverContact{passage.a, passage.b, 0, 0});
  return passage.verdict != ContactVerdict::started &&
         (found == contacts.end() || found->a != passage.a || found->b != passage.b);
}

double moment_of(const Bracket& t) {
  return t.upper <= 1 ? t.upper : t.lower;
}

RigidMotion way_of_step(const Shape& shape, const Pose& before, const Pose& now) {
  return detail::way_between(before, now, shape);
}

}  // namespace soms
