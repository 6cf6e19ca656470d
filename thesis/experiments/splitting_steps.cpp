// Figures 4.23 to 4.26: the center of a triangle, and how a node's triangles are divided.
#include "soms/tree/build.h"

#include "thesis/experiments/experiments.h"
#include "thesis/page/listing.h"
#include "thesis/pictures/side_view.h"
#include "thesis/pictures/toy_pictures.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trees/split_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace soms::reproduce {

namespace {

/// A triangle of figure 4.23.
struct ShownTriangle {
  const char* name = nullptr;
  const char* title = nullptr;
  Triangle triangle;
};

/// In the first, the line from the middle of A and B to C is upright on the side, as the caption
/// says it need not be.
constexpr std::array<ShownTriangle, 2> kShownTriangles{
    {{"isosceles", "Isosceles", {{0, 0, 0}, {12, 0, 0}, {6, 9, 0}}},
     {"oblique", "Oblique", {{0, 0, 0}, {8, 0, 0}, {16, 8, 0}}}}};

/// The points that may stand for a triangle, if corner `c_vertex` is C.
struct Centers {
  Vec3 a;
  Vec3 b;
  Vec3 c;
  Vec3 f;  ///< middle of A and B
  Vec3 thesis;
  Vec3 centroid;
  Vec3 box;
  bool upright = false;  ///< the line from f to C is at right angles to that from A to B
};

Centers centers_of(const Triangle& t, int c_vertex) {
  const std::array<Vec3, 3> corners{t.a, t.b, t.c};
  const auto c = static_cast<std::size_t>(c_vertex);
  Centers centers;
  centers.a = corners[(c + 1) % 3];
  centers.b = corners[(c + 2) % 3];
  centers.c = corners[c];
  centers.f = 0.5 * (centers.a + centers.b);
  centers.thesis = midpoint(t, Midpoint::thesis, c_vertex);
  centers.centroid = midpoint(t, Midpoint::centroid);
  centers.box = midpoint(t, Midpoint::aabb);
  const Vec3 side = centers.b - centers.a;
  const Vec3 line = centers.c - centers.f;
  centers.upright = side.x * line.x + side.y * line.y + side.z * line.z == 0;
  require(centers.thesis == 0.5 * (centers.f + centers.c),
          "the thesis' midpoint and half of f and C");
  return centers;
}

void draw_centers(Svg& svg, const SideView& view, const Centers& centers) {
  const auto at = [&](const Vec3& point) { return view(point); };
  constexpr std::string_view kSide = "class=\"axis\" stroke=\"#1d1f21\" stroke-width=\"1.6\"";
  constexpr std::string_view kThin =
      "class=\"grid\" stroke=\"#8a8d91\" stroke-width=\"1.2\" stroke-dasharray=\"5 3\"";
  svg.line(at(centers.a), at(centers.b), kSide);
  svg.line(at(centers.b), at(centers.c), kSide);
  svg.line(at(centers.c), at(centers.a), kSide);
  svg.line(at(centers.f), at(centers.c), kThin);
  const auto dot = [&](const Vec3& point, std::size_t color, double radius) {
    svg.circle(at(point), radius,
               fmt::format("class=\"f{}\" fill=\"{}\"", color, series_color(color)));
  };
  dot(centers.f, 6, 3.5);
  dot(centers.box, 2, 5);
  dot(centers.centroid, 0, 5);
  dot(centers.thesis, 1, 5.5);
  const Vec3 middle = (1.0 / 3) * (centers.a + centers.b + centers.c);
  const auto letter = [&](const Vec3& point, const char* words) {
    const Spot spot = at(point);
    const Spot from = at(middle);
    svg.text({spot.x + (spot.x > from.x ? 6.0 : -6.0), spot.y + (spot.y > from.y ? 16.0 : -6.0)},
             words,
             {.size = 14,
              .anchor = spot.x > from.x ? Anchor::start : Anchor::end,
              .bold = true,
              .haloed = true});
  };
  letter(centers.a, "A");
  letter(centers.b, "B");
  letter(centers.c, "C");
  letter(centers.f, "f");
}

std::string draw_all_centers(const std::string& title) {
  constexpr double kWidth = 320;
  constexpr double kHeight = 250;
  Svg svg(1000, 112 + 2 * kHeight, title);
  svg.text({20, 30}, title, {.size = 17, .bold = true});
  double x = 20;
  for (const auto& [color, words] :
       {std::pair(std::size_t{1}, "middle of f and C: the thesis' center"),
        std::pair(std::size_t{0}, "centroid"), std::pair(std::size_t{2}, "middle of the box")}) {
    svg.circle({x + 5, 53}, 5,
               fmt::format("class=\"f{0}\" fill=\"{1}\"", color, series_color(color)));
    svg.text({x + 16, 58}, words, {.size = 13});
    x += 40 + text_width(words, 13);
  }
  double y = 78;
  for (const ShownTriangle& shown : kShownTriangles) {
    for (int c = 0; c < 3; ++c) {
      const double left = 20 + kWidth * c;
      const Centers centers = centers_of(shown.triangle, c);
      svg.text({left, y + 16},
               fmt::format("{}, C is corner {}{}", shown.title, c,
                           centers.upright ? ": f to C is upright" : ""),
               {.size = 14, .bold = true});
      draw_centers(svg,
                   SideView(Side::front, bounds(shown.triangle),
                            {{left + 22, y + 46}, kWidth - 64, kHeight - 84}),
                   centers);
    }
    y += kHeight;
  }
  return svg.document();
}

/// A large triangle and three small ones.
const ToySet& divided_set() {
  static const std::vector<ToySet> sets = flat_toy_sets();
  return *std::find_if(sets.begin(), sets.end(),
                       [](const ToySet& set) { return set.name == "one_large"; });
}

std::string corners_of(const Triangle& t) {
  std::string words;
  for (const Vec3& corner : {t.a, t.b, t.c}) {
    words += fmt::format("{}({:g}, {:g})", words.empty() ? "" : " ", corner.x, corner.y);
  }
  return words;
}

}  // namespace

Result figure_4_23(const Context&) {
  Table table{.id = "figure_4_23_centers",
              .caption = "Triangles, corner C, the middle f of the other two, and three centers.",
              .columns = {{"triangle"},
                          {"c_vertex"},
                          {"f_x"},
                          {"f_y"},
                          {"thesis_x"},
                          {"thesis_y"},
                          {"centroid_x"},
                          {"centroid_y"},
                          {"box_x"},
                          {"box_y"},
                          {"upright"}}};
  for (const ShownTriangle& shown : kShownTriangles) {
    for (int c = 0; c < 3; ++c) {
      const Centers of = centers_of(shown.triangle, c);
      table.rows.push_back({word_cell(shown.name), static_cast<std::int64_t>(c), of.f.x, of.f.y,
                            of.thesis.x, of.thesis.y, of.centroid.x, of.centroid.y, of.box.x,
                            of.box.y, yes_cell(of.upright)});
    }
  }
  Figure figure{.id = "figure_4_23",
                .caption =
                    "The center of a triangle as the thesis has it, halfway from C to the "
                    "middle f of A and B, beside the centroid and the middle of the box: "
                    "three corners can be C and give three centers.",
                .svg = draw_all_centers("The center of a triangle depends on which corner is C")};
  for (const ShownTriangle& shown : kShownTriangles) {
    for (int c = 0; c < 3; ++c) {
      const Centers of = centers_of(shown.triangle, c);
      figure.alt += fmt::format(
          "{} triangle, C is corner {}: center ({:.4g}, {:.4g}), centroid ({:.4g}, {:.4g}). ",
          shown.title, c, of.thesis.x, of.thesis.y, of.centroid.x, of.centroid.y);
    }
  }
  return {.tables = {std::move(table)},
          .figures = {std::move(figure)},
          .remarks = {"The center always lies on the line from f to C, at its middle; the centroid "
                      "lies at a third of it. The item options shows what another corner changes "
                      "in trees."}};
}

Result figure_4_24(const Context&) {
  const ToySet& set = divided_set();
  const ToySplit split = split_toy(set.mesh, Rule::soms);
  const Tree tree = build(set.mesh, thesis_options(Rule::soms, 2));
  Table table{.id = "figure_4_24_steps",
              .caption = fmt::format("The root of the set \"{}\" divided triangle by triangle: the "
                                     "plane is {} = {:g}.",
                                     set.title, kAxisNames[split.axis], split.plane),
              .columns = {{"triangle"},
                          {"midpoint"},
                          {"side"},
                          {"stored_vertices"},
                          {"left_count"},
                          {"right_count"}}};
  std::size_t left = 0;
  for (TriangleId id = 0; id < set.mesh.triangles.size(); ++id) {
    left += split.left[id] ? 1U : 0U;
    table.rows.push_back({count_cell(id), split.midpoints[id][split.axis],
                          word_cell(split.left[id] ? "left" : "right"),
                          corners_of(set.mesh.triangle(id)), count_cell(left),
                          count_cell(id + 1 - left)});
  }
  require(tree.nodes.size() == 3 && tree.nodes[1].count == left, "the listing and the build");
  return listing_result(
      "figure_4_24",
      "Which side stores a triangle, and how both sides count, with a real set beside it.",
      {.title = "Triangles stored at the left and at the right",
       .lines = {{0, "store (node, axis, plane):"},
                 {1, "left count = right count = 0"},
                 {1, "for each triangle of node:"},
                 {2, "if its midpoint on axis < plane:"},
                 {3, "put its 3 vertices into the left array"},
                 {3, "left count = left count + 1"},
                 {2, "else:"},
                 {3, "put its 3 vertices into the right array"},
                 {3, "right count = right count + 1"}},
       .heading = fmt::format("the set \"{}\", plane {} = {:g}", set.title, kAxisNames[split.axis],
                              split.plane)},
      std::move(table));
}

Result figure_4_25(const Context&) {
  const ToySet& set = divided_set();
  const ToySplit split = split_toy(set.mesh, Rule::soms);
  const Tree tree = build(set.mesh, thesis_options(Rule::soms, 2));
  Drawing drawing{
      .title = "Triangles of the left and of the right child", .view = flat_view(), .columns = 1};
  drawing.keys = toy_keys(true);
  drawing.panels = {divided_toy_panel(set.mesh, split)};
  drawing.panels[0].title = fmt::format("TreeID 0: {} triangles", set.mesh.triangles.size());
  Table table{.id = "figure_4_25_triangles",
              .caption =
                  "Triangles of the root and of its children in the tree of level 2, in the "
                  "order in which they are stored.",
              .columns = {{"tree_id"}, {"place"}, {"triangle"}}};
  std::vector<Mesh> parts;
  parts.reserve(2);
  for (const Node& node : tree.nodes) {
    const std::span<const TriangleId> ids = tree.triangles_of(node);
    for (std::size_t k = 0; k < ids.size(); ++k) {
      table.rows.push_back({count_cell(node.id), count_cell(k), count_cell(ids[k])});
    }
    if (node.id > 0) {
      parts.push_back(some_of(set.mesh, {ids.begin(), ids.end()}));
      Panel panel = toy_panel(parts.back(), split_toy(parts.back(), Rule::soms));
      panel.title = fmt::format("TreeID {}, {}: {} triangles", node.id,
                                node.id % 2 == 1 ? "left" : "right", node.count);
      drawing.panels.push_back(std::move(panel));
    }
  }
  std::string alt;
  for (const Panel& panel : drawing.panels) {
    alt += panel.title + ". ";
  }
  return {.tables = {std::move(table)},
          .figures = {{.id = "figure_4_25",
                       .caption = fmt::format("The set \"{}\" divided by SOMS: the triangles that "
                                              "the left and the right child get, with their boxes.",
                                              set.title),
                       .svg = draw(drawing),
                       .alt = alt}}};
}

Result figure_4_26(const Context&) {
  const ToySet& set = divided_set();
  const Tree tree = build(set.mesh, thesis_options(Rule::soms, 3));
  Table table = split_table("figure_4_26_steps",
                            fmt::format("The tree of the set \"{}\", SOMS, level 3, in the order "
                                        "in which its nodes are made.",
                                        set.title),
                            split_steps(set.mesh, tree, 3));
  return listing_result("figure_4_26",
                        "The procedure that divides an object, with a real set beside it.",
                        {.title = "Splitting an object",
                         .lines = {{0, "split (TreeID, depth, triangles):"},
                                   {1, "box [TreeID] = least and greatest corners"},
                                   {1, "count [TreeID] = number of triangles"},
                                   {1, "if there is one triangle, or depth is last:"},
                                   {2, "leaf; done"},
                                   {1, "axis = longest axis of the midpoints' box"},
                                   {1, "plane = its middle on the axis"},
                                   {1, "store each triangle left or right of it"},
                                   {1, "if one side is empty:"},
                                   {2, "leaf that cannot be divided; done"},
                                   {1, "split (2 TreeID + 1, depth + 1, left)"},
                                   {1, "split (2 TreeID + 2, depth + 1, right)"}},
                         .heading = fmt::format("the set \"{}\", level 3", set.title)},
                        std::move(table));
}

}  // namespace soms::reproduce
