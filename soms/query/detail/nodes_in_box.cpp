#include "soms/query/detail/nodes_in_box.h"

#include "soms/query/detail/engine/node_id.h"
#include "soms/query/detail/engine/pair_list.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/query/detail/single_box_descent.h"

#include <cstddef>

namespace soms::detail {

void find_nodes(const Box& box, const Body& body, std::vector<std::uint32_t>& ids, Cost& cost) {
  ids.clear();
  const WideTree& tree = body.shape.layout();
  if (box.empty() || tree.empty()) {
    return;
  }
  if (tree.compact() != nullptr) {
    ids.push_back(kRootId);
    return;
  }
  const RelativePose relative(box, ReferenceFrame(tree, body.pose));
  if (relative.apart()) {
    return;
  }
  SingleBox single;
  relative.single_box(single);
  if (!single.pays(tree.nodes()[0])) {
    ids.push_back(kRootId);
    return;
  }
  single.find_place(tree);
  if (single.clear_of(tree)) {
    return;
  }
  PairList stack;
  PairList found;
  single.descend(tree, stack, found, cost);
  for (std::size_t k = 0; k < found.size(); ++k) {
    ids.push_back(found.at(k).y);
  }
}

}  // namespace soms::detail
