// Figures 4.1, 4.3, 4.4, 4.6 and 4.7: each rule's plane on small sets.
#include "soms/tree/rule/rules.h"

#include "thesis/experiments/experiments.h"
#include "thesis/pictures/toy_pictures.h"

#include <fmt/format.h>

#include <array>
#include <span>

namespace soms::reproduce {

namespace {

struct DrawnRule {
  Rule rule;
  const char* title;
};

constexpr DrawnRule kObjectMedian{Rule::object_median, "object median"};
constexpr DrawnRule kObjectMean{Rule::object_mean, "object mean"};
constexpr DrawnRule kSpatialMedian{Rule::spatial_median, "spatial median"};
constexpr DrawnRule kSoms{Rule::soms, "SOMS"};

Table table_of(std::string id, std::string caption) {
  return {.id = std::move(id),
          .caption = std::move(caption),
          .columns = {{"set"}, {"rule"}, {"axis"}, {"plane"}, {"left"}, {"right"}, {"divides"}}};
}

void add_row(Table& table, const ToySet& set, Rule rule, const ToySplit& split) {
  table.rows.push_back({set.name, std::string(entry(rule).name),
                        std::string(1, kAxisNames[split.axis]), split.plane,
                        static_cast<std::int64_t>(split.left_count),
                        static_cast<std::int64_t>(split.left.size() - split.left_count),
                        std::string(split.divides() ? "yes" : "no")});
}

/// Sets in rows, rules in columns. What is drawn goes into `table` too.
Figure rules_figure(std::string id, std::string caption, Drawing drawing,
                    std::span<const ToySet> sets, std::span<const DrawnRule> rules, Table& table) {
  drawing.columns = rules.size() == 3 ? 3 : 2;
  drawing.same_scale = false;
  drawing.keys = toy_keys(true);
  std::string alt;
  for (const ToySet& set : sets) {
    for (std::size_t k = 0; k < rules.size(); ++k) {
      const ToySplit split = split_toy(set.mesh, rules[k].rule);
      Panel panel = divided_toy_panel(set.mesh, split);
      const std::string letter = rules.size() > 1 ? fmt::format("({}) ", "abcd"[k]) : std::string();
      panel.title = sets.size() == 1   ? letter + rules[k].title
                    : rules.size() > 1 ? fmt::format("{}{}: {}", letter, rules[k].title, set.title)
                                       : set.title;
      alt += fmt::format("{}: {}. ", panel.title, panel.note);
      drawing.panels.push_back(std::move(panel));
      add_row(table, set, rules[k].rule, split);
    }
  }
  return {.id = std::move(id), .caption = std::move(caption), .svg = draw(drawing), .alt = alt};
}

}  // namespace

Result figure_4_1(const Context&) {
  constexpr std::array kRules{kObjectMedian, kObjectMean, kSpatialMedian};
  Result result;
  Table table = table_of("figure_4_1_planes",
                         "Plane of the common rules on each toy set, with the thesis' options.");
  result.figures = {rules_figure(
      "figure_4_1",
      "Object median puts half of the triangles on each side, by midpoint and then by number, and "
      "always divides; object mean's plane is at the mean of the midpoints; spatial median's is in "
      "the middle of the outer box.",
      {.title = "The common splitting rules", .view = flat_view()}, flat_toy_sets(), kRules,
      table)};
  result.tables = {std::move(table)};
  result.remarks = {
      "Figures 4.1 to 4.7 are drawn by the functions that build the trees, on sets made by hand; "
      "the pictures of the thesis are not available."};
  return result;
}

Result figure_4_3(const Context&) {
  constexpr std::array kRules{kSpatialMedian, kSoms};
  std::vector<ToySet> sets = flat_toy_sets();
  std::erase_if(
      sets, [](const ToySet& set) { return split_toy(set.mesh, Rule::spatial_median).divides(); });
  Result result;
  Table table = table_of("figure_4_3_planes",
                         "The toy sets that spatial median cannot divide, and what SOMS makes of "
                         "them, with the thesis' options.");
  result.figures = {rules_figure(
      "figure_4_3",
      "Where spatial median's plane leaves one side empty: large triangles move the middle of the "
      "outer box beside all midpoints, or the midpoints agree on its longest axis. SOMS goes on "
      "unless all midpoints are equal.",
      {.title = "Where the plane cannot divide", .view = flat_view()}, sets, kRules, table)};
  result.tables = {std::move(table)};
  return result;
}

Result figure_4_4(const Context&) {
  const std::vector<ToySet> sets = flat_toy_sets();
  Drawing drawing{.title = "The boxes that count", .view = flat_view()};
  drawing.same_scale = false;
  drawing.keys = toy_keys(false);
  Table table{.id = "figure_4_4_boxes",
              .caption = "Outer and inner box of each toy set.",
              .columns = {{"set"},
                          {"outer_width"},
                          {"outer_height"},
                          {"inner_width"},
                          {"inner_height"},
                          {"axis_of_outer"},
                          {"axis_of_inner"}}};
  for (const ToySet& set : sets) {
    const ToySplit outer = split_toy(set.mesh, Rule::spatial_median);
    const ToySplit inner = split_toy(set.mesh, Rule::soms);
    Panel panel = toy_panel(set.mesh, outer);
    panel.title = set.title;
    panel.note = fmt::format("longest axis: {} of the outer box, {} of the inner",
                             kAxisNames[outer.axis], kAxisNames[inner.axis]);
    drawing.panels.push_back(std::move(panel));
    table.rows.push_back({set.name, outer.outer.extent().x, outer.outer.extent().y,
                          outer.inner.extent().x, outer.inner.extent().y,
                          std::string(1, kAxisNames[outer.axis]),
                          std::string(1, kAxisNames[inner.axis])});
  }
  Result result;
  result.figures = {{.id = "figure_4_4",
                     .caption = "Spatial median halves the outer box, of all corners; SOMS halves "
                                "the inner box, of the midpoints.",
                     .svg = draw(drawing),
                     .alt = "Small sets of triangles, each with the box of its corners and the "
                            "smaller box of its midpoints."}};
  result.tables = {std::move(table)};
  return result;
}

Result figure_4_6(const Context&) {
  constexpr std::array kRules{kSoms};
  Result result;
  Table table =
      table_of("figure_4_6_planes", "Plane of SOMS on each toy set, with the thesis' options.");
  result.figures = {rules_figure(
      "figure_4_6",
      "SOMS: the plane halfway between the least and the greatest midpoint. It fails only where "
      "all midpoints are equal.",
      {.title = "The plane of SOMS", .view = flat_view()}, flat_toy_sets(), kRules, table)};
  result.tables = {std::move(table)};
  return result;
}

Result figure_4_7(const Context&) {
  constexpr std::array kRules{kObjectMedian, kSpatialMedian, kObjectMean, kSoms};
  const ToySet set = solid_toy_set();
  Result result;
  Table table = table_of("figure_4_7_planes",
                         "Plane of each rule on four houses and a large ground triangle, with the "
                         "thesis' options.");
  result.figures = {rules_figure(
      "figure_4_7",
      "Four houses on one large ground triangle: spatial median's plane passes beside all "
      "midpoints, the other rules divide.",
      {.title = "Four rules on one set in space", .view = axonometric(UpAxis::z)}, {&set, 1},
      kRules, table)};
  result.tables = {std::move(table)};
  return result;
}

}  // namespace soms::reproduce
