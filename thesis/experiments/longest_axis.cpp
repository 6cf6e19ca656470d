// Figure 4.22: which axis of a box is the longest, ties included.
#include "soms/tree/build.h"

#include "thesis/experiments/experiments.h"
#include "thesis/page/listing.h"
#include "thesis/pictures/toy_pictures.h"
#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace soms::reproduce {

namespace {

/// Midpoints from the origin to this corner, two on each axis.
struct AxisCase {
  const char* name = nullptr;
  Vec3 extent;
};

constexpr std::array<AxisCase, 7> kAxisCases{{{"x longest", {6, 2, 1}},
                                              {"y longest", {2, 6, 1}},
                                              {"z longest", {1, 2, 6}},
                                              {"x and y equal", {6, 6, 1}},
                                              {"x and z equal", {6, 1, 6}},
                                              {"y and z equal", {1, 6, 6}},
                                              {"all equal", {6, 6, 6}}}};

/// The three functions of the listing: exactly one is true.
struct Longest {
  bool x = false;
  bool y = false;
  bool z = false;

  explicit Longest(const Vec3& extent)
      : x(extent.x >= extent.y && extent.x >= extent.z),
        y(!x && extent.y >= extent.z),
        z(!x && !y) {}

  [[nodiscard]] std::size_t axis() const { return x ? 0 : y ? 1 : 2; }
};

/// Triangles on all corners of a box of this extent, so that each axis would divide them otherwise.
Mesh triangles_of(const Vec3& extent) {
  std::vector<Vec3> midpoints;
  for (unsigned k = 0; k < 8; ++k) {
    midpoints.push_back(
        {(k & 1U) != 0 ? extent.x : 0, (k & 2U) != 0 ? extent.y : 0, (k & 4U) != 0 ? extent.z : 0});
  }
  return triangles_at(midpoints);
}

/// The axis on which the library divides the root: bit of the triangles' numbers that are right.
std::size_t built_axis(const Mesh& mesh) {
  const Tree tree = build(mesh, thesis_options(Rule::soms));
  const auto right = tree.triangles_of(tree.nodes.at(tree.nodes.front().right));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (right.size() == 4 && std::all_of(right.begin(), right.end(),
                                         [&](TriangleId id) { return (id >> axis & 1U) != 0; })) {
      return axis;
    }
  }
  require(false, "a division of figure 4.22 along one axis");
  return 0;
}

}  // namespace

Result figure_4_22(const Context&) {
  Table steps{.id = "figure_4_22_axes",
              .caption =
                  "Boxes of eight midpoints: their extent, the three functions, and the axis "
                  "on which the library divides the triangles.",
              .columns = {{"case"},
                          {"extent_x"},
                          {"extent_y"},
                          {"extent_z"},
                          {"is_x"},
                          {"is_y"},
                          {"is_z"},
                          {"divided_on"}}};
  for (const auto& [name, extent] : kAxisCases) {
    const Longest longest(extent);
    const std::size_t axis = built_axis(triangles_of(extent));
    require(longest.axis() == axis, "the functions of figure 4.22 and the tree");
    steps.rows.push_back({word_cell(name), extent.x, extent.y, extent.z, yes_cell(longest.x),
                          yes_cell(longest.y), yes_cell(longest.z),
                          std::string(1, kAxisNames[axis])});
  }
  Result result = listing_result(
      "figure_4_22",
      "Boolean functions that tell the longest axis; exactly one is true. At the right boxes with "
      "and without ties.",
      {.title = "Which axis is the longest",
       .lines = {{0, "is x the longest (extent):"},
                 {1, "x >= y and x >= z"},
                 {0, "is y the longest (extent):"},
                 {1, "not is x the longest, and y >= z"},
                 {0, "is z the longest (extent):"},
                 {1, "neither x nor y is"}},
       .heading = "extents of the box of midpoints"},
      std::move(steps));
  result.remarks = {
      "Of equal extents the first axis wins. The caption does not say what the thesis does with "
      "ties; this is our reading, and SOMS divides by it."};
  return result;
}

}  // namespace soms::reproduce
