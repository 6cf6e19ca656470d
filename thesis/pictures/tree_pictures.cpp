#include "thesis/pictures/tree_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace soms::reproduce {

namespace {

constexpr int kLevel = 0;
constexpr int kEnded = 1;

bool is_on(const Node& node, int level) {
  return static_cast<int>(node.depth) == level - 1;
}

bool ends_above(const Node& node, int level) {
  return node.is_leaf() && static_cast<int>(node.depth) < level - 1;
}

}  // namespace

LevelCount count_level(const Tree& tree, int level) {
  LevelCount count;
  count.fewest = std::numeric_limits<std::int64_t>::max();
  for (const Node& node : tree.nodes) {
    const bool on = is_on(node, level);
    const bool above = ends_above(node, level);
    count.nodes += on ? 1 : 0;
    count.ended += above ? 1 : 0;
    if (on || above) {
      count.most = std::max<std::int64_t>(count.most, node.count);
      count.fewest = std::min<std::int64_t>(count.fewest, node.count);
    }
  }
  count.fewest = std::min(count.fewest, count.most);
  return count;
}

Panel level_panel(const Mesh& mesh, const Tree& tree, int level, std::string title) {
  Panel panel;
  panel.title = std::move(title);
  panel.meshes = {{.mesh = &mesh}};
  for (const Node& node : tree.nodes) {
    if (is_on(node, level)) {
      panel.boxes.push_back({.box = node.bounds, .color = kLevel});
    } else if (ends_above(node, level)) {
      panel.boxes.push_back({.box = node.bounds, .color = kEnded, .dashed = true});
    }
  }
  const LevelCount count = count_level(tree, level);
  panel.note = count.nodes == 0   ? "no box"
               : count.nodes == 1 ? "1 box"
                                  : fmt::format("{} boxes", to_text(count.nodes));
  if (count.ended > 0) {
    panel.note +=
        fmt::format(" and {} {} above", to_text(count.ended), count.ended == 1 ? "leaf" : "leaves");
  }
  panel.note +=
      count.fewest == count.most
          ? fmt::format(": {} triangle{}", to_text(count.most), count.most == 1 ? "" : "s")
          : fmt::format(": {} to {} triangles", to_text(count.fewest), to_text(count.most));
  panel.note += count.nodes + count.ended > 1 ? " each" : "";
  return panel;
}

std::vector<Key> level_keys() {
  return {{KeyKind::box, kLevel, "box of the level"},
          {KeyKind::dashed_box, kEnded, "leaf that ended above it"}};
}

}  // namespace soms::reproduce
