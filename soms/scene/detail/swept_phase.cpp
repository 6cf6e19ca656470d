#include "soms/scene/detail/swept_phase.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/motion/detail/contact_in_box.h"
#include "soms/motion/detail/swept_bounds.h"

#include <string>
#include <utility>

namespace soms::detail {

namespace {

RigidMotion way_from(const Pose& start, const Body& body) {
  return way_between(start, body.pose, body.shape);
}

}  // namespace

void SweptPhase::start(const Residents& movers, std::uint64_t steps) {
  steps_ = steps;
  boxes_.assign(movers.places().size(), {});
  for (std::size_t place = 0; place < boxes_.size(); ++place) {
    const auto& [id, live, resident] = movers.places()[place];
    const Pose* const from = resident.last.left_for(resident.body.pose, steps);
    if (!live || from == nullptr) {
      continue;
    }
    try {
      boxes_[place] = swept_bounds(resident.body.shape, way_from(*from, resident.body));
    } catch (const Error& error) {
      throw Error(error.kind(), "mover " + std::to_string(id) + ": " + error.place(),
                  error.remedy());
    }
  }
}

Cost SweptPhase::ask(std::span<const Candidate> pairs, const Residents& movers,
                     const Residents& others, const Limits& limits) {
  const bool mutual = &movers == &others;
  return answers_.ask(pairs.size(), limits, [&](std::size_t k, const Limits& inside) {
    const PlainArithmetic plain;
    const Resident& mover = movers.places()[pairs[k].mover].value;
    const Resident& other = others.places()[pairs[k].other].value;
    const Pose* const from = mover.last.left_for(mover.body.pose, steps_);
    const Pose* const from_of_other =
        mutual ? other.last.left_for(other.body.pose, steps_) : nullptr;
    if (from != nullptr && from_of_other != nullptr) {
      return first_contact(mover.body.shape, way_from(*from, mover.body), other.body.shape,
                           way_from(*from_of_other, other.body), {}, inside);
    }
    if (from != nullptr) {
      return first_contact_in_box(mover.body.shape, way_from(*from, mover.body),
                                  boxes_[pairs[k].mover], other.body, inside);
    }
    FirstContact answer =
        first_contact_in_box(other.body.shape, way_from(*from_of_other, other.body),
                             boxes_[pairs[k].other], mover.body, inside);
    if (answer.triangles) {
      std::swap(answer.triangles->a, answer.triangles->b);
    }
    return answer;
  });
}

void SweptPhase::give_back(std::size_t movers, std::size_t pairs) {
  detail::give_back(boxes_, movers);
  answers_.give_back(pairs);
}

}  // namespace soms::detail
