// Figures 4.27 to 4.29: triangles by TreeID, how a tree is divided node by node, and how a level of
// it is drawn.
#include "soms/thesis/implicit.h"
#include "soms/tree/build.h"

#include "apps/draw/svg.h"
#include "thesis/experiments/experiments.h"
#include "thesis/page/listing.h"
#include "thesis/pictures/drawing.h"
#include "thesis/pictures/tree_pictures.h"
#include "thesis/run/counts.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trees/split_steps.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::reproduce {

namespace {

constexpr int kArrayLevel = 3;
constexpr int kSplitLevel = 4;
constexpr std::int64_t kFacesOfABox = 6;

/// A set of figure 4.27 in the arrays of the thesis.
struct Arrays {
  ToySet set;
  ImplicitTree tree;
};

std::vector<Arrays> toy_arrays() {
  std::vector<Arrays> all;
  for (ToySet& set : flat_toy_sets()) {
    if (set.name == "one_large" || set.name == "one_midpoint") {
      const Tree tree = build(set.mesh, thesis_options(Rule::soms, kArrayLevel));
      all.push_back({std::move(set), to_implicit(tree, kArrayLevel)});
    }
  }
  return all;
}

std::string triangles_in(const ImplicitTree& tree, const ImplicitTree::Slot& slot) {
  std::string words;
  for (const TriangleId id : tree.triangles_of(slot)) {
    words += fmt::format("{}{}", words.empty() ? "" : " ", id);
  }
  return words;
}

std::string draw_arrays(const std::vector<Arrays>& all, const std::string& title) {
  constexpr double kSlot = 136;
  constexpr double kRow = 128;
  Svg svg(1000, 70 + kRow * static_cast<double>(all.size()), title);
  svg.text({20, 30}, title, {.size = 17, .bold = true});
  double y = 66;
  for (const Arrays& one : all) {
    svg.text({20, y}, fmt::format("the set \"{}\"", one.set.title), {.size = 14, .bold = true});
    double x = 20;
    for (std::size_t id = 0; id < one.tree.slots.size(); ++id, x += kSlot) {
      const ImplicitTree::Slot& slot = one.tree.slots[id];
      svg.rect({x, y + 12}, kSlot, 76,
               slot.used ? "class=\"f5\" fill=\"#56b4e9\" fill-opacity=\"0.25\" stroke=\"#5c5f63\""
                         : "fill=\"none\" stroke=\"#8a8d91\" stroke-dasharray=\"4 4\"");
      svg.text({x + 8, y + 30}, fmt::format("TreeID {}", id), {.size = 12, .faint = true});
      if (slot.used) {
        svg.text({x + 8, y + 54},
                 fmt::format("{} triangle{}", slot.count, slot.count == 1 ? "" : "s"),
                 {.size = 14, .bold = true});
        svg.text({x + 8, y + 76}, "no. " + triangles_in(one.tree, slot), {.size = 13});
      } else {
        svg.text({x + 8, y + 54}, "not used", {.size = 13, .faint = true});
      }
    }
    y += kRow;
  }
  return svg.document();
}

Table slots_table(const Context& context) {
  Table table{.id = "figure_4_27_slots",
              .caption = fmt::format("Slots that arrays by TreeID have and SOMS uses: objects at "
                                     "level {}, scenes at {}.",
                                     kObjectLevel, kSceneLevel),
              .columns = {{"model"}, {"level"}, {"slots"}, {"used"}, {"used_share", "%"}}};
  const auto add = [&](std::span<const Model> models, int level) {
    for (const Model& model : models) {
      check_stop(context.limits);
      const Tree tree = build(*model.mesh, thesis_options(Rule::soms, level));
      const ImplicitTree arrays = to_implicit(tree, level);
      const auto used = static_cast<std::uint64_t>(
          std::count_if(arrays.slots.begin(), arrays.slots.end(),
                        [](const ImplicitTree::Slot& slot) { return slot.used; }));
      require(used == tree.nodes.size(), "slots in use and nodes of the tree");
      table.rows.push_back(
          {model.name, static_cast<std::int64_t>(level), count_cell(arrays.slots.size()),
           count_cell(used),
           100 * static_cast<double>(used) / static_cast<double>(arrays.slots.size())});
    }
  };
  add(context.models.objects, kObjectLevel);
  add(context.models.scenes, kSceneLevel);
  table.caption += note_on_stand_ins(context.models.objects);
  table.caption += note_on_stand_ins(context.models.scenes);
  return table;
}

/// The boxes after a step: what is divided now in red, what waits or is done in blue.
Panel step_panel(const Mesh& mesh, const Tree& tree, const std::vector<SplitStep>& steps,
                 std::size_t divided) {
  Panel panel;
  panel.meshes = {{.mesh = &mesh}};
  std::size_t splits = 0;
  for (const SplitStep& step : steps) {
    if (!step.divided || splits == divided) {
      continue;
    }
    ++splits;
    const bool now = splits == divided;
    panel.boxes.push_back(
        {.box = step.node->bounds, .color = now ? kHighlight : 6, .dashed = true});
    for (const std::uint32_t child : {step.node->left, step.node->right}) {
      panel.boxes.push_back({.box = tree.nodes[child].bounds, .color = now ? 1 : 0});
    }
    if (now) {
      const std::size_t all = step.split.left.size();
      panel.title = fmt::format("Step {}: TreeID {}", divided, step.node->id);
      panel.note = fmt::format("{} = {:.4g}: {} to TreeID {}, {} to {}", "xyz"[step.split.axis],
                               step.split.plane, step.split.left_count, 2 * step.node->id + 1,
                               all - step.split.left_count, 2 * step.node->id + 2);
    }
  }
  return panel;
}

/// What a drawing of one level did.
struct Rendered {
  std::int64_t visited = 0;
  std::int64_t drawn = 0;
};

/// The listing of figure 4.29.
void render(const ImplicitTree& tree, TreeId id, int level, Rendered& counts) {
  if (tree.find(id) == nullptr) {
    return;
  }
  ++counts.visited;
  if (depth_of(id) == level - 1 || tree.is_leaf(id)) {
    ++counts.drawn;
    return;
  }
  render(tree, left_child_of(id), level, counts);
  render(tree, right_child_of(id), level, counts);
}

}  // namespace

Result figure_4_27(const Context& context) {
  const std::vector<Arrays> all = toy_arrays();
  Table table{
      .id = "figure_4_27_arrays",
      .caption = fmt::format("Two small sets in arrays by TreeID, SOMS, level {}.", kArrayLevel),
      .columns = {{"set"}, {"tree_id"}, {"used"}, {"count"}, {"triangles"}, {"vertices"}}};
  std::string alt;
  for (const Arrays& one : all) {
    for (std::size_t id = 0; id < one.tree.slots.size(); ++id) {
      const ImplicitTree::Slot& slot = one.tree.slots[id];
      table.rows.push_back({one.set.name, count_cell(id), yes_cell(slot.used),
                            slot.used ? count_cell(slot.count) : Cell{},
                            slot.used ? Cell{triangles_in(one.tree, slot)} : Cell{},
                            slot.used ? count_cell(3 * std::uint64_t{slot.count}) : Cell{}});
      alt += slot.used ? fmt::format("{}, TreeID {}: triangles {}. ", one.set.title, id,
                                     triangles_in(one.tree, slot))
                       : "";
    }
  }
  Table slots = slots_table(context);
  return {.tables = {std::move(table), std::move(slots)},
          .figures = {{.id = "figure_4_27",
                       .caption = "Count and triangles of each node in arrays by TreeID, for two "
                                  "small sets: places of nodes that do not exist stay empty.",
                       .svg = draw_arrays(all, "Triangles of each node, by TreeID"),
                       .alt = alt}},
          .remarks = {"The caption stores vertices; here numbers of triangles are shown, three "
                      "vertices each."}};
}

Result figure_4_28(const Context&) {
  const ToySet set = grid_toy_set();
  const Tree tree = build(set.mesh, thesis_options(Rule::soms, kSplitLevel));
  const std::vector<SplitStep> steps = split_steps(set.mesh, tree, kSplitLevel);
  const auto splits = static_cast<std::size_t>(
      std::count_if(steps.begin(), steps.end(), [](const SplitStep& one) { return one.divided; }));
  Drawing drawing{.title = "A tree divided node by node", .view = flat_view()};
  drawing.keys = {{KeyKind::dashed_box, kHighlight, "node that is divided"},
                  {KeyKind::box, 1, "its children"},
                  {KeyKind::box, 0, "made before"}};
  std::string alt;
  for (std::size_t k = 1; k <= splits; ++k) {
    drawing.panels.push_back(step_panel(set.mesh, tree, steps, k));
    alt += fmt::format("{}: {}. ", drawing.panels.back().title, drawing.panels.back().note);
  }
  return {.tables = {split_table("figure_4_28_steps",
                                 fmt::format("The tree of the set \"{}\", SOMS, level {}, in the "
                                             "order in which its nodes are made.",
                                             set.title, kSplitLevel),
                                 steps)},
          .figures = {{.id = "figure_4_28",
                       .caption = fmt::format("SOMS divides the set \"{}\" down to level {}: {} "
                                              "steps, depth first, left before right.",
                                              set.title, kSplitLevel, splits),
                       .svg = draw(drawing),
                       .alt = alt}}};
}

Result figure_4_29(const Context& context) {
  const Model& object = context.models.objects.front();
  const Tree tree = build(*object.mesh, thesis_options(Rule::soms, kObjectLevel));
  const ImplicitTree arrays = to_implicit(tree, kObjectLevel);
  Table table{
      .id = "figure_4_29_levels",
      .caption = fmt::format("Levels of the tree of {}, SOMS, level {}, drawn one at a "
                             "time: nodes that are visited, boxes and faces drawn.{}",
                             object.name, kObjectLevel, note_on_stand_ins(std::span(&object, 1))),
      .columns = {{"level"}, {"visited"}, {"boxes"}, {"leaves_above"}, {"faces"}}};
  for (int level = 1; level <= kObjectLevel; ++level) {
    Rendered counts;
    render(arrays, 0, level, counts);
    const LevelCount expected = count_level(tree, level);
    require(counts.drawn == expected.nodes + expected.ended, "boxes drawn and nodes of the level");
    table.rows.push_back({static_cast<std::int64_t>(level), counts.visited, counts.drawn,
                          expected.ended, kFacesOfABox * counts.drawn});
  }
  return listing_result("figure_4_29",
                        "How one level of a tree is drawn, and what that takes level by level.",
                        {.title = "Rendering a level of a tree",
                         .lines = {{0, "render (TreeID, level):"},
                                   {1, "if there is no node TreeID:"},
                                   {2, "done"},
                                   {1, "if its depth is level - 1, or it is a leaf:"},
                                   {2, "draw the 6 faces of its box"},
                                   {2, "done"},
                                   {1, "render (2 TreeID + 1, level)"},
                                   {1, "render (2 TreeID + 2, level)"}},
                         .heading = fmt::format("render (0, level), {}, SOMS", label_of(object))},
                        std::move(table));
}

}  // namespace soms::reproduce
