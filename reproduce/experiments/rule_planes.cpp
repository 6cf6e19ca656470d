// Figures 4.2 to 4.7: each rule's plane on small sets.
#include "soms/tree/rule/rules.h"

#include "reproduce/drawing.h"
#include "reproduce/experiments/experiments.h"
#include "reproduce/toy_sets.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::reproduce {

namespace {

constexpr int kLeft = 5;
constexpr int kRight = 4;
constexpr int kOuter = 6;
constexpr int kInner = 3;
constexpr int kPlane = 1;
constexpr int kMidpoint = 6;
constexpr std::string_view kAxes = "xyz";

struct DrawnRule {
  Rule rule;
  const char* title;
};

constexpr std::array<DrawnRule, 4> kRules{{{Rule::object_median, "object median"},
                                           {Rule::object_mean, "object mean"},
                                           {Rule::spatial_median, "spatial median"},
                                           {Rule::soms, "SOMS"}}};

std::vector<Key> keys(bool sides) {
  std::vector<Key> all;
  if (sides) {
    all = {{KeyKind::fill, kLeft, "left"},
           {KeyKind::fill, kRight, "right"},
           {KeyKind::fill, kClay, "undivided"},
           {KeyKind::plane, kPlane, "plane"}};
  }
  all.push_back({KeyKind::point, kMidpoint, "midpoint"});
  all.push_back({KeyKind::box, kOuter, "outer box"});
  all.push_back({KeyKind::dashed_box, kInner, "inner box, of midpoints"});
  return all;
}

/// Triangles, midpoints and boxes of a set.
Panel panel_of(const Mesh& mesh, const ToySplit& split) {
  Panel panel;
  panel.meshes = {{.mesh = &mesh}};
  panel.boxes = {{.box = split.outer, .color = kOuter},
                 {.box = split.inner, .color = kInner, .dashed = true}};
  for (const Vec3& midpoint : split.midpoints) {
    panel.points.push_back({midpoint, kMidpoint});
  }
  return panel;
}

/// The same with the plane of the rule and what lies on its two sides.
Panel divided_panel(const Mesh& mesh, const ToySplit& split) {
  Panel panel = panel_of(mesh, split);
  if (split.divides()) {
    for (const bool left : split.left) {
      panel.meshes[0].colors.push_back(left ? kLeft : kRight);
    }
  }
  Box within = split.outer;
  const Vec3 rim = 0.06 * split.outer.extent();
  within.lower = within.lower - rim;
  within.upper = within.upper + rim;
  panel.planes = {{split.axis, split.plane, within, kPlane}};
  panel.note = fmt::format("plane {} = {:.4g}: {}", kAxes[split.axis], split.plane,
                           split.divides() ? fmt::format("{} left, {} right", split.left_count,
                                                         split.left.size() - split.left_count)
                                           : std::string("one side is empty, the rule fails"));
  return panel;
}

Table table_of(std::string id, std::string caption) {
  return {.id = std::move(id),
          .caption = std::move(caption),
          .columns = {{"set"}, {"rule"}, {"axis"}, {"plane"}, {"left"}, {"right"}, {"divides"}}};
}

void add_row(Table& table, const ToySet& set, Rule rule, const ToySplit& split) {
  table.rows.push_back({set.name, std::string(entry(rule).name), std::string(1, kAxes[split.axis]),
                        split.plane, static_cast<std::int64_t>(split.left_count),
                        static_cast<std::int64_t>(split.left.size() - split.left_count),
                        std::string(split.divides() ? "yes" : "no")});
}

/// One rule on all sets of two dimensions.
Result rule_figure(const std::string& number, const DrawnRule& drawn, const std::string& words) {
  const std::vector<ToySet> sets = flat_toy_sets();
  Drawing drawing{.title = fmt::format("The plane of {}", drawn.title), .view = flat_view()};
  drawing.same_scale = false;
  drawing.keys = keys(true);
  Table table =
      table_of(fmt::format("figure_{}_planes", number),
               fmt::format("Plane of {} on each toy set, with the thesis' options.", drawn.title));
  std::string alt;
  for (const ToySet& set : sets) {
    const ToySplit split = split_toy(set.mesh, drawn.rule);
    Panel panel = divided_panel(set.mesh, split);
    panel.title = set.title;
    alt += fmt::format("{}: {}. ", set.title, panel.note);
    drawing.panels.push_back(std::move(panel));
    add_row(table, set, drawn.rule, split);
  }
  Result result;
  result.figures = {
      {.id = fmt::format("figure_{}", number), .caption = words, .svg = draw(drawing), .alt = alt}};
  result.tables = {std::move(table)};
  return result;
}

/// Toy sets whose midpoints are not all equal, and how many of these a rule divides.
struct Divided {
  std::size_t sets = 0;
  std::size_t by_rule = 0;
};

Divided count_divided(Rule rule) {
  Divided count;
  std::vector<ToySet> sets = flat_toy_sets();
  sets.push_back(solid_toy_set());
  for (const ToySet& set : sets) {
    const ToySplit split = split_toy(set.mesh, rule);
    if (split.inner.lower != split.inner.upper) {
      ++count.sets;
      count.by_rule += split.divides() ? 1U : 0U;
    }
  }
  return count;
}

}  // namespace

Result figure_4_2(const Context&) {
  Result result = rule_figure("4_2", kRules[0],
                              "Object median: half of the triangles to each side, by midpoint and "
                              "then by number, so it always divides.");
  result.remarks = {
      "Figures 4.2 to 4.7 are drawn by the functions that build the trees, on sets made by hand. "
      "The pictures of the thesis are not available: which of its figures 4.2, 4.3, 4.5 and 4.7 "
      "shows which rule is our reading."};
  return result;
}

Result figure_4_3(const Context&) {
  return rule_figure("4_3", kRules[1],
                     "Object mean: the plane at the mean of the midpoints. It fails where all "
                     "midpoints agree on the axis.");
}

Result figure_4_4(const Context&) {
  const std::vector<ToySet> sets = flat_toy_sets();
  Drawing drawing{.title = "The boxes that count", .view = flat_view()};
  drawing.same_scale = false;
  drawing.keys = keys(false);
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
    Panel panel = panel_of(set.mesh, outer);
    panel.title = set.title;
    panel.note = fmt::format("longest axis: {} of the outer box, {} of the inner",
                             kAxes[outer.axis], kAxes[inner.axis]);
    drawing.panels.push_back(std::move(panel));
    table.rows.push_back({set.name, outer.outer.extent().x, outer.outer.extent().y,
                          outer.inner.extent().x, outer.inner.extent().y,
                          std::string(1, kAxes[outer.axis]), std::string(1, kAxes[inner.axis])});
  }
  Result result;
  result.figures = {{.id = "figure_4_4",
                     .caption = "Spatial median halves the outer box, of all corners; SOMS halves "
                                "the inner box, of the midpoints.",
                     .svg = draw(drawing),
                     .alt = "Four small sets of triangles, each with the box of its corners and "
                            "the smaller box of its midpoints."}};
  result.tables = {std::move(table)};
  return result;
}

Result figure_4_5(const Context&) {
  return rule_figure("4_5", kRules[2],
                     "Spatial median: the plane in the middle of the outer box. One large triangle "
                     "is enough for all midpoints to lie on one side of it.");
}

Result figure_4_6(const Context&) {
  Result result =
      rule_figure("4_6", kRules[3],
                  "SOMS: the plane halfway between the least and the greatest midpoint. It fails "
                  "only where all midpoints are equal.");
  const Divided soms = count_divided(Rule::soms);
  const Divided spatial = count_divided(Rule::spatial_median);
  const bool holds = soms.by_rule == soms.sets && spatial.by_rule < spatial.sets;
  result.findings = {
      {.claim = "Triangles of unlike size stop spatial median, which then needs a fallback; SOMS "
                "goes on without one",
       .source = "statement of the problem",
       .measured = fmt::format("of {} toy sets whose midpoints are not all equal, SOMS divides {}, "
                               "spatial median {}",
                               soms.sets, soms.by_rule, spatial.by_rule),
       .verdict = holds ? Verdict::holds : Verdict::does_not_hold,
       .reason = "SOMS puts its plane between two different midpoints wherever there are two; "
                 "spatial median's plane depends on corners, which may lie far beyond them."}};
  return result;
}

Result figure_4_7(const Context&) {
  const ToySet set = solid_toy_set();
  Drawing drawing{.title = "Four rules on one set in space", .view = axonometric(UpAxis::z)};
  drawing.keys = keys(true);
  Table table = table_of("figure_4_7_planes",
                         "Plane of each rule on four houses and a large ground triangle, with the "
                         "thesis' options.");
  std::string alt;
  for (const DrawnRule& drawn : kRules) {
    const ToySplit split = split_toy(set.mesh, drawn.rule);
    Panel panel = divided_panel(set.mesh, split);
    panel.title = drawn.title;
    alt += fmt::format("{}: {}. ", drawn.title, panel.note);
    drawing.panels.push_back(std::move(panel));
    add_row(table, set, drawn.rule, split);
  }
  Result result;
  result.figures = {{.id = "figure_4_7",
                     .caption = "Four houses on one large ground triangle: spatial median's plane "
                                "passes beside all midpoints, the other rules divide.",
                     .svg = draw(drawing),
                     .alt = alt}};
  result.tables = {std::move(table)};
  return result;
}

}  // namespace soms::reproduce
