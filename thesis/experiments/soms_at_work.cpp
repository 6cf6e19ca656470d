// Figures 4.2 and 4.5: SOMS beside spatial median on a small set, and SOMS in pseudo code.
#include "soms/tree/build.h"
#include "soms/tree/rule/rules.h"
#include "soms/tree/statistics.h"

#include "thesis/experiments/experiments.h"
#include "thesis/page/listing.h"
#include "thesis/pictures/toy_pictures.h"
#include "thesis/pictures/tree_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace soms::reproduce {

namespace {

constexpr int kLastDrawnLevel = 5;

/// A tree of the toy set and up to which level it is full.
struct ToyTree {
  const char* title = nullptr;
  Rule rule = Rule::soms;
  Tree tree = {};
  std::uint64_t balanced = 0;
};

ToyTree toy_tree(const char* title, Rule rule, const Mesh& mesh) {
  const BuildOptions options = thesis_options(rule);
  Tree tree = build(mesh, options);
  const std::uint64_t balanced = statistics(tree, options).balanced_level;
  return {title, rule, std::move(tree), balanced};
}

std::string point(const Vec3& at) {
  return fmt::format("({:.4g}, {:.4g})", at.x, at.y);
}

std::vector<CodeLine> pseudo_code(const ToySplit& split) {
  std::string midpoints;
  for (const Vec3& at : split.midpoints) {
    midpoints += fmt::format("{}{}", midpoints.empty() ? "" : " ", point(at));
  }
  const Box& inner = split.inner;
  const char axis = kAxisNames[split.axis];
  const std::size_t right = split.left.size() - split.left_count;
  return {
      {0, "divide (triangles, level):", fmt::format("{} triangles", split.left.size())},
      {1, "if there is one triangle or the level is the last:"},
      {2, "make a leaf; done", "no"},
      {1, "for each triangle A, B, C:"},
      {2, "midpoint = halfway from C to the middle of A and B", midpoints},
      {1, "inner = the box of all midpoints",
       fmt::format("{} to {}", point(inner.lower), point(inner.upper))},
      {1, "axis = x, y or z, where inner is longest",
       fmt::format("{}: {:.4g} wide, {:.4g} high", axis, inner.extent().x, inner.extent().y)},
      {1, "plane = middle of inner on this axis", fmt::format("{} = {:.4g}", axis, split.plane)},
      {1, "for each triangle:"},
      {2, "left, if its midpoint is below the plane; else right",
       fmt::format("{} left, {} right", split.left_count, right)},
      {1, "if left or right is empty:"},
      {2, "make a leaf; done (all midpoints are equal)", split.divides() ? "no" : "yes"},
      {1, "divide (left, level + 1)", fmt::format("{} triangles", split.left_count)},
      {1, "divide (right, level + 1)", fmt::format("{} triangles", right)},
  };
}

}  // namespace

Result figure_4_2(const Context&) {
  const ToySet set = grid_toy_set();
  const std::array trees{toy_tree("spatial median", Rule::spatial_median, set.mesh),
                         toy_tree("SOMS", Rule::soms, set.mesh)};
  Drawing drawing{.title = "The same set divided by spatial median and by SOMS",
                  .view = flat_view()};
  drawing.keys = level_keys();
  Table table{.id = "figure_4_2_levels",
              .caption = "Boxes of the two trees of the set, with the thesis' options.",
              .columns = {{"set"},
                          {"rule"},
                          {"level"},
                          {"nodes"},
                          {"leaves_above"},
                          {"fewest_triangles"},
                          {"most_triangles"},
                          {"balanced_level"}}};
  std::string alt;
  for (int level = 2; level <= kLastDrawnLevel; ++level) {
    for (const ToyTree& of : trees) {
      Panel panel =
          level_panel(set.mesh, of.tree, level, fmt::format("{}, level {}", of.title, level));
      alt += fmt::format("{}: {}. ", panel.title, panel.note);
      drawing.panels.push_back(std::move(panel));
      const LevelCount count = count_level(of.tree, level);
      table.rows.push_back({set.name, std::string(entry(of.rule).name),
                            static_cast<std::int64_t>(level), count.nodes, count.ended,
                            count.fewest, count.most, static_cast<std::int64_t>(of.balanced)});
    }
  }
  Result result;
  result.figures = {
      {.id = "figure_4_2",
       .caption = fmt::format("Fifteen small triangles and a large one, whose midpoints are a "
                              "regular grid: the tree of spatial median is full to level {}, that "
                              "of SOMS to level {}.",
                              trees[0].balanced, trees[1].balanced),
       .svg = draw(drawing),
       .alt = alt}};
  result.tables = {std::move(table)};
  result.remarks = {
      "The set is made by hand to show what is meant. Which rule keeps more levels balanced on "
      "models stands in the item balance."};
  return result;
}

Result figure_4_5(const Context&) {
  const std::vector<ToySet> sets = flat_toy_sets();
  const auto shown = std::find_if(sets.begin(), sets.end(),
                                  [](const ToySet& set) { return set.name == "one_large"; });
  const Listing listing{.title = "How SOMS divides",
                        .lines = pseudo_code(split_toy(shown->mesh, Rule::soms)),
                        .heading = fmt::format("the set \"{}\"", shown->title)};
  Table table{.id = "figure_4_5_lines",
              .caption = fmt::format("SOMS line by line, with the thesis' options, and what each "
                                     "line does with the set \"{}\".",
                                     shown->title),
              .columns = {{"line"}, {"indent"}, {"code"}, {"example"}}};
  for (const CodeLine& line : listing.lines) {
    table.rows.push_back({static_cast<std::int64_t>(table.rows.size() + 1),
                          static_cast<std::int64_t>(line.indent), line.code,
                          line.example.empty() ? Cell{} : Cell{line.example}});
  }
  Result result;
  result.figures = {listing_figure("figure_4_5",
                                   fmt::format("SOMS in pseudo code of our own, and at the right "
                                               "what each line does with one of the small sets.{}",
                                               kFromCaption),
                                   listing)};
  result.tables = {std::move(table)};
  return result;
}

}  // namespace soms::reproduce
