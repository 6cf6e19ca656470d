#include "soms/motion/detail/contact_in_box.h"

#include "soms/base/double_limits.h"
#include "soms/motion/detail/contact_query.h"
#include "soms/motion/detail/rigid_law.h"
#include "soms/query/detail/nodes_in_box.h"

#include <cstdint>
#include <vector>

namespace soms::detail {

FirstContact first_contact_in_box(const Shape& mover, const RigidMotion& way, const Box& box,
                                  const Body& rests, const Limits& limits) {
  std::vector<std::uint32_t> nodes;
  Cost cost;
  find_nodes(box, rests, nodes, cost);
  FirstContact answer{.t = {1, kInfinity}};
  if (!nodes.empty()) {
    const RigidLaw law(mover, way, rests);
    answer = first_contact_by(law, mover, rests.shape, {}, limits, {.nodes = nodes});
    const bool decided =
        answer.verdict == ContactVerdict::free || answer.verdict == ContactVerdict::started;
    if (!decided && nodes.front() != kRootId) {
      cost += answer.cost;  // which pairs are looked at decides the last bits of a bracket
      answer = first_contact_by(law, mover, rests.shape, {}, limits);
    }
  }
  answer.cost += cost;
  return answer;
}

}  // namespace soms::detail
