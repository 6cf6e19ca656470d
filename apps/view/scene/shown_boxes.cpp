#include "apps/view/scene/shown_boxes.h"

#include "soms/base/error.h"
#include "soms/base/hash.h"

#include <algorithm>
#include <string>
#include <tuple>

namespace soms::view {

namespace {

/// Keys of the groups, three for each tree of a traversal; meshes have theirs apart.
constexpr std::uint64_t kLevelKey = 1;
constexpr std::uint64_t kFirstTraceKey = 2;
constexpr std::uint64_t kSecondTraceKey = 5;

void add(Fnv1a& hash, Color color) {
  hash.add_byte(color.r);
  hash.add_byte(color.g);
  hash.add_byte(color.b);
  hash.add_byte(color.a);
}

/// A number that is another whenever the boxes of a level are.
std::uint64_t version_of_level(const ViewScene& scene, const ViewOptions& options,
                               std::uint64_t mesh) {
  Fnv1a hash;
  hash.add(scene.trees_version());
  hash.add(mesh);
  hash.add(static_cast<std::uint32_t>(options.level->level));
  hash.add_byte(options.level->leaves_above ? 1 : 0);
  hash.add(std::uint64_t{options.most_boxes});
  add(hash, options.colors.level);
  add(hash, options.colors.leaf_above);
  return hash.value();
}

/// The same for the boxes of a traversal.
std::uint64_t version_of_trace(const ViewScene& scene, const ViewOptions& options) {
  Fnv1a hash;
  hash.add(scene.trace_version());
  hash.add_byte(options.trace->visited ? 1 : 0);
  hash.add_byte(options.trace->pruned ? 1 : 0);
  hash.add_byte(options.trace->found ? 1 : 0);
  hash.add(std::uint64_t{options.most_boxes});
  add(hash, options.colors.visited);
  add(hash, options.colors.pruned);
  add(hash, options.colors.found);
  return hash.value();
}

/// Keeps the largest boxes; those of equal size in their order.
void cut(std::vector<BoxItem>& boxes, std::size_t most) {
  if (boxes.size() <= most) {
    return;
  }
  std::stable_sort(boxes.begin(), boxes.end(), [](const BoxItem& a, const BoxItem& b) {
    return half_area(a.box) > half_area(b.box);
  });
  boxes.resize(most);
}

void add_group(ShownBoxes& out, BoxGroup group, std::size_t most) {
  out.boxes += group.boxes.size();
  cut(group.boxes, most);
  out.groups.push_back(std::move(group));
}

void add_level(ViewScene& scene, const ViewOptions& options, ShownBoxes& out) {
  const LevelBoxes& level = *options.level;
  const Tree& tree = scene.tree(level.body);
  BoxGroup group;
  group.key = kLevelKey;
  group.version = version_of_level(
      scene, options, scene.mesh_facts().of(scene.body(level.body).shape.shared_mesh()).key);
  group.pose = scene.body(level.body).pose;
  group.style = level.style;
  for (const std::uint32_t n : nodes_of_level(tree, level.level, level.leaves_above)) {
    const Node& node = tree.nodes[n];
    const bool above = node.depth + 1 < static_cast<std::uint32_t>(level.level);
    group.boxes.push_back({node.bounds, above ? options.colors.leaf_above : options.colors.level});
  }
  add_group(out, std::move(group), options.most_boxes);
}

void add_trace(ViewScene& scene, const ViewOptions& options, bool first, ShownBoxes& out) {
  const TraceBoxes& wanted = *options.trace;
  const TraversalTrace& trace = scene.trace();
  if (!scene.pair() || trace.a.empty()) {
    return;
  }
  const std::vector<Fate>& fates = first ? trace.a : trace.b;
  const auto boxes = scene.world_boxes(first ? scene.pair()->first : scene.pair()->second);
  // Found ones last and thicker, so that they show among the others.
  std::uint64_t key = first ? kFirstTraceKey : kSecondTraceKey;
  for (const auto& [fate, show, color] :
       {std::tuple(Fate::pruned, wanted.pruned, options.colors.pruned),
        std::tuple(Fate::visited, wanted.visited, options.colors.visited),
        std::tuple(Fate::found, wanted.found, options.colors.found)}) {
    BoxGroup group;
    group.key = key++;
    group.version = version_of_trace(scene, options);
    group.width = fate == Fate::found ? 2 : 1;
    for (std::size_t n = 0; show && n < fates.size(); ++n) {
      if (fates[n] == fate && !boxes[n].empty()) {
        group.boxes.push_back({boxes[n], color});
      }
    }
    if (show) {
      add_group(out, std::move(group), options.most_boxes);
    }
  }
}

}  // namespace

std::vector<std::uint32_t> nodes_of_level(const Tree& tree, int level, bool leaves_above) {
  if (level < 1) {
    throw Error(ErrorKind::usage, "level " + std::to_string(level) + " of a tree",
                "levels are numbered from 1, the root");
  }
  const auto depth = static_cast<std::uint32_t>(level - 1);
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    const Node& node = tree.nodes[n];
    if (!node.bounds.empty() &&
        (node.depth == depth || (leaves_above && node.depth < depth && node.is_leaf()))) {
      nodes.push_back(n);
    }
  }
  return nodes;
}

ShownBoxes shown_boxes(ViewScene& scene, const ViewOptions& options) {
  ShownBoxes out;
  if (options.level) {
    add_level(scene, options, out);
  }
  if (options.trace && options.trace->city) {
    add_trace(scene, options, true, out);
  }
  if (options.trace && options.trace->mover) {
    add_trace(scene, options, false, out);
  }
  return out;
}

}  // namespace soms::view
