// Figures 4.32 and 4.33: the test of the roots, and the test of two boxes.
#include "thesis/experiments/experiments.h"
#include "thesis/pictures/side_view.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trips/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace soms::reproduce {

namespace {

/// Frames that figure 4.32 shows: far, touching, half inside.
constexpr std::array<std::size_t, 3> kShownFrames{0, 32, 48};

Box moved(const Box& box, const Vec3& by) {
  return {box.lower + by, box.upper + by};
}

/// Frames of a trip in which the roots are tested and in which they overlap.
struct Roots {
  std::string still;
  std::string test;
  std::uint64_t frames = 0;
  std::uint64_t overlap = 0;
};

Roots test_roots(const Box& still, const Box& moving, const std::vector<Vec3>& offsets) {
  Roots roots;
  for (const Vec3& offset : offsets) {
    ++roots.frames;
    roots.overlap += overlaps(still, moved(moving, offset)) ? 1U : 0U;
  }
  return roots;
}

std::vector<Roots> all_roots(const Models& models) {
  const Model& object = models.objects.front();
  const Box box = bounds(*object.mesh);
  std::vector<Roots> all;
  for (const auto& [from, name] : kAllApproaches) {
    Roots roots = test_roots(box, box, orientation_test(box, from));
    roots.still = object.name;
    roots.test = name;
    all.push_back(std::move(roots));
  }
  const Box mover = bounds(transformed(*object.mesh, kDriveScale, UpAxis::y));
  for (const Model& scene : models.scenes) {
    Roots roots = test_roots(bounds(*scene.mesh), mover, city_drive());
    roots.still = scene.name;
    roots.test = "drive";
    all.push_back(std::move(roots));
  }
  return all;
}

std::string draw_roots(const Mesh& mesh, const std::string& title) {
  const Box box = bounds(mesh);
  const std::vector<Vec3> offsets = orientation_test(box, Approach::right);
  Box shown = box;
  shown.grow(moved(box, offsets.front()));
  constexpr double kHeight = 150;
  Svg svg(1000, 60 + kHeight * static_cast<double>(kShownFrames.size()), title);
  svg.text({20, 30}, title, {.size = 17, .bold = true});
  double y = 50;
  for (const std::size_t frame : kShownFrames) {
    const SideView view(Side::front, shown, {{330, y}, 640, kHeight - 16});
    const Box other = moved(box, offsets[frame]);
    const bool hit = overlaps(box, other);
    svg.text({20, y + 40}, fmt::format("frame {}: {}", frame, hit ? "overlap" : "apart"),
             {.size = 15, .bold = true});
    svg.text({20, y + 64}, hit ? "the traversal goes down" : "no node below is looked at",
             {.size = 13, .faint = true});
    for (const auto& [at, by, color] :
         {std::tuple(&box, Vec3{}, 0), std::tuple(&other, offsets[frame], 1)}) {
      svg.path(view.facing(mesh, by),
               fmt::format("class=\"f{0}\" fill=\"{1}\" fill-opacity=\"0.3\"", color,
                           series_color(static_cast<std::size_t>(color))));
      svg.path(view.box(*at),
               fmt::format("class=\"s{0}\" fill=\"none\" stroke=\"{1}\" stroke-width=\"2\"", color,
                           series_color(static_cast<std::size_t>(color))));
    }
    y += kHeight;
  }
  return svg.document();
}

/// A pair of boxes of figure 4.33.
struct BoxCase {
  const char* name = nullptr;
  const char* title = nullptr;
  Box other;
};

constexpr Box kStill{{0, 0, 0}, {6, 5, 4}};

constexpr std::array<BoxCase, 5> kBoxCases{
    {{"overlap", "on all axes: overlap", {{4, 2, 1}, {10, 8, 6}}},
     {"touching", "touching on x: overlap", {{6, 2, 1}, {10, 8, 6}}},
     {"apart_x", "apart on x", {{7, 2, 1}, {10, 8, 6}}},
     {"apart_y", "apart on y", {{4, 7, 1}, {10, 9, 6}}},
     {"apart_z", "apart on z", {{4, 2, 5}, {10, 8, 7}}}}};

bool overlaps_on(const Box& a, const Box& b, std::size_t axis) {
  return a.lower[axis] <= b.upper[axis] && b.lower[axis] <= a.upper[axis];
}

/// Intervals of both boxes on the three axes.
void draw_case(Svg& svg, const BoxCase& one, Spot corner) {
  constexpr double kUnit = 24;
  svg.text({corner.x, corner.y}, one.title, {.size = 15, .bold = true});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double y = corner.y + 24 + 34 * static_cast<double>(axis);
    const auto bar = [&](const Box& box, double at, std::size_t color) {
      svg.rect({corner.x + 26 + kUnit * box.lower[axis], at},
               kUnit * (box.upper[axis] - box.lower[axis]), 9,
               fmt::format("class=\"f{}\" fill=\"{}\"", color, series_color(color)));
    };
    svg.text({corner.x, y + 13}, std::string(1, "xyz"[axis]), {.size = 14});
    bar(kStill, y, 0);
    bar(one.other, y + 11, 1);
    svg.text({corner.x + 36 + kUnit * 10, y + 14},
             overlaps_on(kStill, one.other, axis) ? "overlap" : "apart", {.size = 13});
  }
}

}  // namespace

Result figure_4_32(const Context& context) {
  const Model& object = context.models.objects.front();
  Table table{.id = "figure_4_32_roots",
              .caption =
                  "Frames of each test, one test of the roots each: in how many they "
                  "overlap, and in how many nothing else is looked at.",
              .columns = {{"still"}, {"test"}, {"frames"}, {"roots_overlap"}, {"ended_there"}}};
  std::uint64_t frames = 0;
  std::uint64_t ended = 0;
  for (const Roots& roots : all_roots(context.models)) {
    table.rows.push_back({roots.still, roots.test, count_cell(roots.frames),
                          count_cell(roots.overlap), count_cell(roots.frames - roots.overlap)});
    frames += roots.frames;
    ended += roots.frames - roots.overlap;
  }
  return {.tables = {std::move(table)},
          .figures = {{.id = "figure_4_32",
                       .caption = fmt::format("The broad phase: the boxes of the roots, test right "
                                              "in frames {}, {} and {}. Only where they overlap "
                                              "are the trees traversed.",
                                              kShownFrames[0], kShownFrames[1], kShownFrames[2]),
                       .svg = draw_roots(*object.mesh, "The roots are tested first")}},
          .remarks = {fmt::format("In {} of {} frames of all tests the test of the roots is the "
                                  "only one.",
                                  to_text(count_cell(ended)), to_text(count_cell(frames))),
                      object_remark(object)}};
}

Result figure_4_33(const Context&) {
  const std::string title = "Two boxes overlap if their intervals overlap on all three axes";
  Svg svg(1000, 480, title);
  svg.text({20, 30}, title, {.size = 17, .bold = true});
  Table table{.id = "figure_4_33_boxes",
              .caption =
                  "Pairs of boxes: on which axes their intervals overlap, and whether the "
                  "boxes do.",
              .columns = {{"case"}, {"x"}, {"y"}, {"z"}, {"overlap"}}};
  std::string alt;
  for (std::size_t k = 0; k < kBoxCases.size(); ++k) {
    const BoxCase& one = kBoxCases[k];
    const std::size_t column = k % 2;
    const std::size_t row_of_case = k / 2;
    draw_case(
        svg, one,
        {20 + 490 * static_cast<double>(column), 66 + 138 * static_cast<double>(row_of_case)});
    std::vector<Cell> row{word_cell(one.name)};
    bool all = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      row.push_back(yes_cell(overlaps_on(kStill, one.other, axis)));
      all = all && overlaps_on(kStill, one.other, axis);
    }
    const bool hit = overlaps(kStill, one.other);
    require(hit == all, "the overlap of two boxes and of their intervals");
    row.push_back(yes_cell(hit));
    table.rows.push_back(std::move(row));
    alt += fmt::format("{}. ", one.title);
  }
  return {.tables = {std::move(table)},
          .figures = {{.id = "figure_4_33",
                       .caption = "Intervals of two boxes (blue, orange) on the three axes: the "
                                  "boxes are apart as soon as one axis is; boxes that touch "
                                  "overlap.",
                       .svg = svg.document(),
                       .alt = alt}}};
}

}  // namespace soms::reproduce
