#include "thesis/pictures/tree_diagram.h"

#include "apps/draw/svg.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::reproduce {

namespace {

constexpr double kDiagramWidth = 1000;
constexpr double kFirstNodeX = 130;
constexpr double kRootY = 100;
constexpr double kRowHeight = 100;
constexpr double kRadius = 17;
constexpr double kWordSize = 12;

/// Leaves at equal distances in their order, parents above the middle of their children.
std::vector<Spot> spots_of(const Tree& tree) {
  const auto leaves = std::count_if(tree.nodes.begin(), tree.nodes.end(),
                                    [](const Node& node) { return node.is_leaf(); });
  const double step = (kDiagramWidth - 20 - kFirstNodeX) / static_cast<double>(leaves);
  std::vector<Spot> spots(tree.nodes.size());
  double x = kDiagramWidth - 20 + step / 2;
  // Children come after their parents, so that backwards both are placed before it.
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const Node& node = tree.nodes[i];
    spots[i].y = kRootY + kRowHeight * node.depth;
    if (node.is_leaf()) {
      x -= step;
      spots[i].x = x;
    } else {
      spots[i].x = (spots[node.left].x + spots[node.right].x) / 2;
    }
  }
  return spots;
}

void draw_lines(Svg& svg, Spot at, const std::vector<std::string>& words, Anchor anchor) {
  svg.lines(at, words, {.size = kWordSize, .anchor = anchor, .faint = true, .haloed = true});
}

void draw_node(Svg& svg, const Node& node, Spot at) {
  const bool left = node.id % 2 == 1;
  const std::size_t color = node.id == 0 ? 6 : (left ? 0 : 1);
  svg.circle(at, kRadius,
             fmt::format("class=\"paper s{0}\" fill=\"#fff\" stroke=\"{1}\" stroke-width=\"2.5\"",
                         color, series_color(color)));
  svg.text({at.x, at.y + 5}, std::to_string(node.id),
           {.size = 15, .anchor = Anchor::middle, .bold = true});
}

}  // namespace

std::string draw_tree(const TreeDiagram& diagram) {
  const Tree& tree = *diagram.tree;
  const std::vector<Spot> spots = spots_of(tree);
  std::uint32_t deepest = 0;
  for (const Node& node : tree.nodes) {
    deepest = std::max(deepest, node.depth);
  }
  Svg svg(kDiagramWidth, kRootY + kRowHeight * deepest + 66, diagram.title);
  svg.text({20, 30}, diagram.title, {.size = 17, .bold = true});
  svg.text({20, 52}, diagram.subtitle, {.size = 13, .faint = true});
  for (std::uint32_t depth = 0; diagram.row_words && depth <= deepest; ++depth) {
    draw_lines(svg, {20, kRootY + kRowHeight * depth}, diagram.row_words(depth), Anchor::start);
  }
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (!tree.nodes[i].is_leaf()) {
      for (const std::uint32_t child : {tree.nodes[i].left, tree.nodes[i].right}) {
        svg.line(spots[i], spots[child], "class=\"grid\" stroke=\"#c8ccd0\" stroke-width=\"1.5\"");
      }
    }
  }
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    draw_node(svg, tree.nodes[i], spots[i]);
    if (diagram.words) {
      draw_lines(svg, {spots[i].x, spots[i].y + kRadius + 15}, diagram.words(tree.nodes[i]),
                 Anchor::middle);
    }
  }
  return svg.document();
}

}  // namespace soms::reproduce
