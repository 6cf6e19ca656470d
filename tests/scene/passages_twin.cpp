#include "tests/scene/passages_twin.h"

#include "soms/motion/first_contact.h"
#include "soms/query/overlap.h"

#include <utility>

namespace soms::test {

namespace {

/// A body, and where it was at the begin of the way if it moves; an empty one never does.
struct MovingBody {
  const Body& body;
  const Pose* before = nullptr;

  MovingBody(const Body& b, const Pose* from)
      : body(b),
        before(from == nullptr || *from == b.pose || b.shape.bounds().empty() ? nullptr : from) {}

  [[nodiscard]] RigidMotion way() const {
    return RigidMotion::between(*before, body.pose, body.shape.bounds().center());
  }
};

FirstContact contact_of(const MovingBody& a, const MovingBody& b) {
  if (a.before != nullptr && b.before != nullptr) {
    return first_contact(a.body.shape, a.way(), b.body.shape, b.way());
  }
  if (a.before != nullptr) {
    return first_contact(a.body.shape, a.way(), b.body);
  }
  if (b.before == nullptr) {
    return {};
  }
  FirstContact answer = first_contact(b.body.shape, b.way(), a.body);
  if (answer.triangles) {
    std::swap(answer.triangles->a, answer.triangles->b);
  }
  return answer;
}

template <typename Passage>
void add_passage(std::vector<Passage>& passages, std::uint32_t a, const MovingBody& first,
                 std::uint32_t b, const MovingBody& second) {
  const FirstContact answer = contact_of(first, second);
  const bool parted = answer.verdict != ContactVerdict::started ||
                      !overlap(first.body, second.body, {.mode = OverlapMode::any}).any;
  if (answer.verdict != ContactVerdict::free && parted) {
    passages.push_back(
        {a, b, answer.triangles->a, answer.triangles->b, answer.verdict, answer.t, answer.point});
  }
}

}  // namespace

Passages passages(const Scene& scene, const std::map<MoverId, Pose>& before,
                  const reference::ComparedPairs& compared) {
  const auto moving = [&](MoverId id) {
    const auto at = before.find(id);
    return MovingBody(scene.mover(id), at == before.end() ? nullptr : &at->second);
  };
  Passages found;
  reference::for_each_compared_pair(
      scene, compared,
      [&](MoverId mover, EnvironmentId part) {
        add_passage(found.environment, mover, moving(mover), part,
                    MovingBody(scene.environment(part), nullptr));
      },
      [&](MoverId a, MoverId b) { add_passage(found.movers, a, moving(a), b, moving(b)); });
  return found;
}

}  // namespace soms::test
