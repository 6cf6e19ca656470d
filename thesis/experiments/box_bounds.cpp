// Figures 4.8 and 4.13: how the box of a set is found, and how it follows a set that moves.
#include "soms/thesis/posed_boxes.h"
#include "soms/tree/build.h"

#include "thesis/experiments/experiments.h"
#include "thesis/page/listing.h"
#include "thesis/pictures/projection.h"
#include "thesis/pictures/toy_pictures.h"
#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace soms::reproduce {

namespace {

constexpr int kRootBox = 0;
constexpr int kInnerBox = 2;
constexpr int kLeafBox = 1;
constexpr int kMovedCorner = 6;

void add_box_columns(Table& table) {
  for (const char* const side : {"least", "greatest"}) {
    for (const char axis : kAxisNames) {
      table.columns.push_back({fmt::format("{}_{}", side, axis)});
    }
  }
}

void add_box_cells(std::vector<Cell>& row, const Box& box) {
  for (const Vec3& at : {box.lower, box.upper}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      row.emplace_back(at[axis]);
    }
  }
}

/// A box that grows corner by corner, as the listing of figure 4.8 says.
struct Loop {
  Box box;
  std::string found = {};  ///< what the last corner changed

  void take(const Vec3& corner) {
    found.clear();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (corner[axis] < box.lower[axis]) {
        box.lower[axis] = corner[axis];
        note("least", axis);
      }
      if (corner[axis] > box.upper[axis]) {
        box.upper[axis] = corner[axis];
        note("greatest", axis);
      }
    }
  }

 private:
  void note(const char* side, std::size_t axis) {
    found += fmt::format("{}{} {}", found.empty() ? "" : ", ", side, kAxisNames[axis]);
  }
};

/// A pose of figure 4.13.
struct NamedPose {
  const char* name = nullptr;
  Pose pose;
};

/// The turn has sine 3/5 and cosine 4/5; its quaternion is (3, 0, 0, 1), made as long as 1.
std::array<NamedPose, 2> poses() {
  const Vec3 shift{2, 1, 0};
  return {{{"shift", Pose::translation(shift.x, shift.y, shift.z)},
           {"turn and shift",
            Pose::from_quaternion(0.94868329805051381, 0, 0, 0.31622776601683794, shift)}}};
}

/// A tree whose boxes follow a pose by both ways.
struct Updated {
  PosedBoxes refit;
  PosedBoxes rebox;

  Updated(const Mesh& mesh, const Tree& tree, const Pose& pose)
      : refit(mesh, tree), rebox(mesh, tree) {
    refit.move(pose, BoxUpdate::refit);
    rebox.move(pose, BoxUpdate::rebox);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      Box tight;
      for (const TriangleId id : tree.triangles_of(tree.nodes[i])) {
        tight.grow(bounds(refit.triangle(id)));
      }
      require(refit.boxes()[i] == tight, "refit and the bounds of the moved triangles");
      require(rebox.boxes()[i].contains(tight), "rebox and the moved triangles");
    }
  }
};

double sum_of_volumes(const std::vector<Box>& boxes) {
  double sum = 0;
  for (const Box& box : boxes) {
    sum += volume(box);
  }
  return sum;
}

std::vector<Box> boxes_of(const Tree& tree) {
  std::vector<Box> boxes;
  for (const Node& node : tree.nodes) {
    boxes.push_back(node.bounds);
  }
  return boxes;
}

Panel update_panel(const Mesh& mesh, const Tree& tree, const std::vector<Box>& boxes,
                   std::string title) {
  Panel panel;
  panel.title = std::move(title);
  panel.note = fmt::format("volumes of all boxes: {:.4g}", sum_of_volumes(boxes));
  panel.meshes = {{.mesh = &mesh}};
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Node& node = tree.nodes[i];
    panel.boxes.push_back(
        {.box = boxes[i],
         .color = node.depth == 0 ? kRootBox : (node.is_leaf() ? kLeafBox : kInnerBox),
         .dashed = node.is_leaf()});
  }
  return panel;
}

Table update_table(const Mesh& mesh, const Tree& tree) {
  Table table{.id = "figure_4_13_boxes",
              .caption =
                  "Boxes of the small tree before it moves and after, by both ways; the "
                  "ratio is that of the volumes, rebox to refit.",
              .columns = {{"pose"}, {"tree_id"}, {"triangles"}, {"update"}}};
  add_box_columns(table);
  table.columns.push_back({"volume"});
  table.columns.push_back({"ratio"});
  const auto add = [&](const char* pose, std::size_t node, const char* update, const Box& box,
                       Cell ratio) {
    std::vector<Cell> row{word_cell(pose), count_cell(tree.nodes[node].id),
                          count_cell(tree.nodes[node].count), word_cell(update)};
    add_box_cells(row, box);
    row.emplace_back(volume(box));
    row.push_back(std::move(ratio));
    table.rows.push_back(std::move(row));
  };
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    add("none", i, "before", tree.nodes[i].bounds, {});
  }
  for (const auto& [name, pose] : poses()) {
    const Updated updated(mesh, tree, pose);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      const Box& tight = updated.refit.boxes()[i];
      const Box& loose = updated.rebox.boxes()[i];
      add(name, i, "refit", tight, {});
      add(name, i, "rebox", loose, volume(loose) / volume(tight));
    }
  }
  return table;
}

}  // namespace

Result figure_4_8(const Context&) {
  const ToySet set = space_toy_set();
  Table steps{.id = "figure_4_8_steps",
              .caption = fmt::format("The loops over \"{}\": the box after each corner, and what "
                                     "the corner changed.",
                                     set.title),
              .columns = {{"triangle"}, {"corner"}, {"x"}, {"y"}, {"z"}}};
  add_box_columns(steps);
  steps.columns.push_back({"found"});
  Loop loop;
  for (TriangleId id = 0; id < set.mesh.triangles.size(); ++id) {
    const Triangle triangle = set.mesh.triangle(id);
    std::uint64_t corner = 0;
    for (const Vec3& at : {triangle.a, triangle.b, triangle.c}) {
      loop.take(at);
      std::vector<Cell> row{count_cell(id), count_cell(corner++), at.x, at.y, at.z};
      add_box_cells(row, loop.box);
      row.push_back(word_cell(loop.found.empty() ? "nothing" : loop.found));
      steps.rows.push_back(std::move(row));
    }
  }
  require(loop.box == build(set.mesh, thesis_options(Rule::soms)).nodes.front().bounds,
          "the loops of figure 4.8 and the box of the root");
  return listing_result(
      "figure_4_8",
      "The box of a set: loops over triangles, corners and axes keep the least and the greatest "
      "coordinate. Run on four triangles, the loops end at the box of the root of their tree.",
      {.title = "How the box of a set is found",
       .lines = {{0, "box (triangles):"},
                 {1, "least = +infinity, greatest = -infinity on each axis"},
                 {1, "for each triangle:"},
                 {2, "for each of its three corners:"},
                 {3, "for each axis x, y, z:"},
                 {4, "if the corner is below least: least = corner"},
                 {4, "if the corner is above greatest: greatest = corner"},
                 {1, "the box reaches from least to greatest"}},
       .heading = fmt::format("the set \"{}\": the box after each corner", set.title)},
      std::move(steps));
}

Result figure_4_13(const Context&) {
  const ToySet set = space_toy_set();
  const Tree tree = build(set.mesh, thesis_options(Rule::soms));
  const NamedPose shown = poses().back();
  const Updated updated(set.mesh, tree, shown.pose);
  Mesh moved = set.mesh;
  moved.vertices = updated.refit.vertices();
  Drawing drawing{.title = "Boxes of a tree that turns, seen from above",
                  .view = flat_view(),
                  .columns = 3,
                  .keys = {{KeyKind::box, kRootBox, "root"},
                           {KeyKind::box, kInnerBox, "inner node"},
                           {KeyKind::dashed_box, kLeafBox, "leaf"},
                           {KeyKind::point, kMovedCorner, "moved corner of the root's box"}}};
  drawing.panels = {update_panel(set.mesh, tree, boxes_of(tree), "before"),
                    update_panel(moved, tree, updated.refit.boxes(), "after, refit"),
                    update_panel(moved, tree, updated.rebox.boxes(), "after, rebox")};
  for (const Vec3& corner : corners(tree.nodes.front().bounds)) {
    drawing.panels.back().points.push_back({shown.pose.apply(corner), kMovedCorner});
  }
  Result result;
  result.figures = {
      {.id = "figure_4_13",
       .caption = fmt::format(
           "The box of a set that moves, by two ways. Refit takes the bounds of the moved "
           "triangles; rebox takes the bounds of the eight moved corners of each box, which is "
           "cheaper but looser: after this turn the root's box has {:.3g} times the volume. Drawn "
           "from the caption; which way the thesis takes is not known.",
           volume(updated.rebox.boxes().front()) / volume(updated.refit.boxes().front())),
       .svg = draw(drawing),
       .alt = "Four triangles with the boxes of their tree: before, turned with refitted boxes, "
              "turned with the larger boxes of the moved corners."}};
  result.tables = {update_table(set.mesh, tree)};
  result.remarks = {
      "The turn has a sine of 3/5. Where a pose only shifts, both ways give the same boxes, but "
      "for one unit in the last place by which rebox widens. In every pose rebox holds the "
      "refitted boxes: this run checked it at each node."};
  return result;
}

}  // namespace soms::reproduce
