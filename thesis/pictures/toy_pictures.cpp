#include "thesis/pictures/toy_pictures.h"

#include <fmt/format.h>

namespace soms::reproduce {

namespace {

constexpr int kLeftColor = 5;
constexpr int kRightColor = 4;
constexpr int kOuter = 6;
constexpr int kInner = 3;
constexpr int kPlane = 1;
constexpr int kMidpoint = 6;

}  // namespace

std::vector<Key> toy_keys(bool sides) {
  std::vector<Key> all;
  if (sides) {
    all = {{KeyKind::fill, kLeftColor, "left"},
           {KeyKind::fill, kRightColor, "right"},
           {KeyKind::fill, kClay, "undivided"},
           {KeyKind::plane, kPlane, "plane"}};
  }
  all.push_back({KeyKind::point, kMidpoint, "midpoint"});
  all.push_back({KeyKind::box, kOuter, "outer box"});
  all.push_back({KeyKind::dashed_box, kInner, "inner box, of midpoints"});
  return all;
}

Panel toy_panel(const Mesh& mesh, const ToySplit& split) {
  Panel panel;
  panel.meshes = {{.mesh = &mesh}};
  panel.boxes = {{.box = split.outer, .color = kOuter},
                 {.box = split.inner, .color = kInner, .dashed = true}};
  for (const Vec3& midpoint : split.midpoints) {
    panel.points.push_back({midpoint, kMidpoint});
  }
  return panel;
}

Panel divided_toy_panel(const Mesh& mesh, const ToySplit& split) {
  Panel panel = toy_panel(mesh, split);
  if (split.divides()) {
    for (const bool left : split.left) {
      panel.meshes[0].colors.push_back(left ? kLeftColor : kRightColor);
    }
  }
  Box within = split.outer;
  const Vec3 rim = 0.06 * split.outer.extent();
  within.lower = within.lower - rim;
  within.upper = within.upper + rim;
  panel.planes = {{split.axis, split.plane, within, kPlane}};
  panel.note = fmt::format("plane {} = {:.4g}: {}", kAxisNames[split.axis], split.plane,
                           split.divides() ? fmt::format("{} left, {} right", split.left_count,
                                                         split.left.size() - split.left_count)
                                           : std::string("one side is empty, the rule fails"));
  return panel;
}

}  // namespace soms::reproduce
