// The orientation tests: from where the moving object comes (table 3.2, figure 3.8).
#include "thesis/experiments/experiments.h"
#include "thesis/pictures/side_view.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trips/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};

/// Frame in which the boxes of an object and its like touch.
constexpr std::size_t kTouch = 32;

std::string direction(ApproachLine line) {
  const std::string_view axis = kAxes[line.axis];
  return line.side > 0 ? fmt::format("from +{0} to -{0}", axis)
                       : fmt::format("from -{0} to +{0}", axis);
}

bool in_thesis(Approach from) {
  return std::any_of(kApproaches.begin(), kApproaches.end(),
                     [&](const auto& named) { return named.first == from; });
}

/// One view: the object in the middle, the same object where it touches on each side, and arrows.
class ApproachView {
 public:
  ApproachView(Svg& svg, const Mesh& mesh, Side side, Spot corner)
      : svg_(svg),
        mesh_(mesh),
        box_(bounds(mesh)),
        view_(side, reach(box_), {{corner.x, corner.y + 30}, 460, 440}) {
    svg_.path(view_.facing(mesh, {}),
              "class=\"f5\" fill=\"#56b4e9\" fill-opacity=\"0.55\" stroke=\"#5c5f63\" "
              "stroke-width=\"0.3\"");
  }

  void approach(Approach from, std::string_view name) {
    const Vec3 touch = orientation_test(box_, from)[kTouch];
    svg_.path(view_.facing(mesh_, touch),
              in_thesis(from) ? "class=\"f4\" fill=\"#e69f00\" fill-opacity=\"0.4\""
                              : "class=\"f2\" fill=\"#009e73\" fill-opacity=\"0.3\"");
    const Spot tail = view_(box_.center() + 1.5 * touch);
    const Spot head = view_(box_.center() + 0.75 * touch);
    arrow(tail, head);
    svg_.text({tail.x, tail.y < head.y ? tail.y - 8 : tail.y + 20}, name,
              {.size = 15, .anchor = Anchor::middle, .bold = true, .haloed = true});
  }

 private:
  /// The object with room for its likes on every side.
  static Box reach(const Box& box) {
    const Vec3 by = 1.15 * box.extent();
    return {box.lower - by, box.upper + by};
  }

  /// Along an axis of the page.
  void arrow(Spot tail, Spot head) {
    constexpr std::string_view kLine = "class=\"axis\" stroke=\"#1d1f21\" stroke-width=\"2\"";
    svg_.line(tail, head, kLine);
    const double x = head.x > tail.x + 1 ? 1 : head.x < tail.x - 1 ? -1 : 0;
    const double y = head.y > tail.y + 1 ? 1 : head.y < tail.y - 1 ? -1 : 0;
    svg_.line(head, {head.x - 9 * x - 5 * y, head.y - 9 * y - 5 * x}, kLine);
    svg_.line(head, {head.x - 9 * x + 5 * y, head.y - 9 * y + 5 * x}, kLine);
  }

  Svg& svg_;
  const Mesh& mesh_;
  Box box_;
  SideView view_;
};

}  // namespace

Result table_3_2(const Context& context) {
  check_stop(context.limits);
  const Model& object = context.models.objects.front();
  Table table{.id = "table_3_2",
              .caption =
                  "The orientation tests: axis and direction of the moving object, with its "
                  "offset in the first frame, where the boxes touch, and in the last.",
              .columns = {{"test"},
                          {"axis"},
                          {"direction"},
                          {"in_thesis"},
                          {"offset_frame_0"},
                          {"offset_frame_32"},
                          {"offset_frame_48"}}};
  for (const auto& [from, name] : kAllApproaches) {
    const ApproachLine line = approach_line(from);
    const std::vector<Vec3> offsets = orientation_test(bounds(*object.mesh), from);
    table.rows.push_back({word_cell(name), word_cell(kAxes[line.axis]), direction(line),
                          yes_cell(in_thesis(from)), offsets.front()[line.axis],
                          offsets[kTouch][line.axis], offsets.back()[line.axis]});
  }
  return {.tables = {std::move(table)},
          .remarks = {object_remark(object),
                      "The thesis names four tests and shows figures of three (no bottom). Axis up "
                      "is y. Offsets are our reconstruction: two widths of the still object to "
                      "half a width in 48 equal steps, in units of the file."}};
}

Result figure_3_8(const Context& context) {
  check_stop(context.limits);
  const Model& object = context.models.objects.front();
  const std::string title = "The object and from where its like comes at it";
  Svg svg(980, 540, title);
  svg.text({20, 28}, title, {.size = 17, .bold = true});
  svg.text({250, 524}, "seen from the front (x to the right, y up)",
           {.anchor = Anchor::middle, .faint = true});
  svg.text({730, 524}, "seen from the right (-z to the right, y up)",
           {.anchor = Anchor::middle, .faint = true});
  ApproachView from_front(svg, *object.mesh, Side::front, {20, 30});
  ApproachView from_right(svg, *object.mesh, Side::right, {500, 30});
  for (const auto& [from, name] : kAllApproaches) {
    (approach_line(from).axis == 2 ? from_right : from_front).approach(from, name);
  }
  return {.figures = {{.id = "figure_3_8",
                       .caption = "The still object (blue) and the moving one where their boxes "
                                  "touch: from the right, left, top and bottom as in the thesis "
                                  "(orange), and from the front and back, which we add (green).",
                       .svg = svg.document()}},
          .remarks = {object_remark(object)}};
}

}  // namespace soms::reproduce
