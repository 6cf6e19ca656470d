// Figures 4.9 to 4.12: the corners of a box, their numbers, and its six faces.
#include "soms/geometry/defects.h"

#include "thesis/experiments/experiments.h"
#include "thesis/page/listing.h"
#include "thesis/pictures/projection.h"
#include "thesis/pictures/side_view.h"
#include "thesis/pictures/toy_pictures.h"
#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace soms::reproduce {

namespace {

/// Least or greatest on an axis: corner k takes the greatest x, y, z for the bits 1, 2, 4 of k.
std::string_view side_of(std::size_t corner, std::size_t axis) {
  return (corner >> axis & 1U) != 0 ? "greatest" : "least";
}

/// A face of a box: its corners counter-clockwise as seen from outside.
struct Face {
  std::size_t axis = 0;
  bool upper = false;
  std::array<std::size_t, 4> corners = {};

  [[nodiscard]] std::string name() const {
    return fmt::format("{} {}", upper ? "greatest" : "least", kAxisNames[axis]);
  }

  [[nodiscard]] std::string numbers() const {
    return fmt::format("{} {} {} {}", corners[0], corners[1], corners[2], corners[3]);
  }
};

/// As the listing of figure 4.11 says; the order of the viewer, z first.
std::array<Face, 6> faces() {
  std::array<Face, 6> all;
  for (std::size_t k = 0; k < 6; ++k) {
    Face& face = all[k];
    face.axis = 2 - k / 2;
    face.upper = k % 2 == 1;
    const std::size_t start = face.upper ? std::size_t{1} << face.axis : 0;
    const std::size_t next = std::size_t{1} << (face.axis + 1) % 3;
    const std::size_t last = std::size_t{1} << (face.axis + 2) % 3;
    face.corners = face.upper ? std::array{start, start | next, start | next | last, start | last}
                              : std::array{start, start | last, start | next | last, start | next};
  }
  return all;
}

/// The faces as twelve triangles.
Mesh mesh_of(const Box& box, const std::array<Face, 6>& faces) {
  Mesh mesh;
  const auto all = corners(box);
  mesh.vertices.assign(all.begin(), all.end());
  for (const Face& face : faces) {
    const auto number = [&](std::size_t k) { return static_cast<std::uint32_t>(face.corners[k]); };
    mesh.triangles.push_back({number(0), number(1), number(2)});
    mesh.triangles.push_back({number(0), number(2), number(3)});
  }
  return mesh;
}

/// Signed volume that a mesh encloses; positive where its triangles turn outward.
double enclosed(const Mesh& mesh) {
  double sum = 0;
  for (TriangleId id = 0; id < mesh.triangles.size(); ++id) {
    const Triangle t = mesh.triangle(id);
    sum += dot(t.a, cross(t.b, t.c));
  }
  return sum / 6;
}

std::string point_words(const Vec3& at) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", at.x, at.y, at.z);
}

/// A box in a rectangle of the page, seen as all figures in space.
class BoxSketch {
 public:
  BoxSketch(const Box& box, const PagePlace& place)
      : from_(frame_of(axonometric(UpAxis::z))), all_(corners(box)), far_(far_corner(all_, from_)) {
    PageBounds bounds;
    bounds.take(from_, box);
    scale_ = std::min(place.width / bounds.width(), place.height / bounds.height());
    origin_ = {place.corner.x + place.width / 2 - scale_ * (bounds.left + bounds.right) / 2,
               place.corner.y + place.height / 2 - scale_ * (bounds.top + bounds.bottom) / 2};
  }

  [[nodiscard]] Spot operator()(const Vec3& point) const {
    const Vec3 seen = from_.on_page(point);
    return {origin_.x + scale_ * seen.x, origin_.y + scale_ * seen.y};
  }

  [[nodiscard]] Spot corner(std::size_t k) const { return (*this)(all_[k]); }

  /// Whether the reader looks at the outside of a face.
  [[nodiscard]] bool shows(const Face& face) const {
    return std::find(face.corners.begin(), face.corners.end(), far_) == face.corners.end();
  }

  /// Edges; those behind the box are dashed.
  void draw_edges(Svg& svg, std::string_view attributes) const {
    std::array<Spot, 8> spots;
    std::transform(all_.begin(), all_.end(), spots.begin(), *this);
    const BoxEdges edges = edges_of(spots, far_);
    svg.path(edges.front.data(), fmt::format("fill=\"none\" {}", attributes));
    svg.path(edges.hidden.data(),
             fmt::format("fill=\"none\" {} stroke-dasharray=\"3 5\"", attributes));
  }

 private:
  look::CameraFrame from_;
  std::array<Vec3, 8> all_;
  std::size_t far_;  ///< the corner that the box hides
  double scale_ = 1;
  Spot origin_;
};

constexpr std::string_view kEdge = "class=\"s0\" stroke=\"#0072b2\" stroke-width=\"2\"";
constexpr std::string_view kFaintEdge = "class=\"axis\" stroke=\"#8a8d91\" stroke-width=\"1\"";

/// The set within its box; `label` writes beside corner k.
template <class Label>
std::string draw_corners(const std::string& title, const std::string& subtitle, const ToySet& set,
                         const Label& label) {
  constexpr double kHeight = 520;
  Svg svg(900, kHeight, title);
  svg.text({20, 30}, title, {.size = 17, .bold = true});
  svg.text({20, 52}, subtitle, {.size = 13, .faint = true});
  const BoxSketch sketch(bounds(set.mesh), {{200, 100}, 500, 370});
  for (TriangleId id = 0; id < set.mesh.triangles.size(); ++id) {
    const Triangle t = set.mesh.triangle(id);
    PathData path;
    path.next(sketch(t.a)).next(sketch(t.b)).next(sketch(t.c)).close();
    svg.path(path.data(), "class=\"f6\" fill=\"#555\" fill-opacity=\"0.22\"");
  }
  sketch.draw_edges(svg, kEdge);
  for (std::size_t k = 0; k < 8; ++k) {
    label(svg, k, sketch.corner(k));
  }
  return svg.document();
}

/// An arrow along an edge, short of its ends.
void draw_arrow(Svg& svg, Spot from, Spot to) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const Spot along{(to.x - from.x) / length, (to.y - from.y) / length};
  const Spot tip{to.x - 15 * along.x, to.y - 15 * along.y};
  const Spot foot{tip.x - 10 * along.x, tip.y - 10 * along.y};
  svg.line({from.x + 15 * along.x, from.y + 15 * along.y}, foot,
           "class=\"s1\" stroke=\"#d55e00\" stroke-width=\"2.2\"");
  PathData head;
  head.next(tip)
      .next({foot.x - 4 * along.y, foot.y + 4 * along.x})
      .next({foot.x + 4 * along.y, foot.y - 4 * along.x})
      .close();
  svg.path(head.data(), "class=\"f1\" fill=\"#d55e00\"");
}

void draw_number(Svg& svg, std::size_t k, Spot at) {
  svg.circle(at, 11, "class=\"paper s0\" fill=\"#fff\" stroke=\"#0072b2\" stroke-width=\"1.5\"");
  svg.text({at.x, at.y + 4.5}, std::to_string(k),
           {.size = 13, .anchor = Anchor::middle, .bold = true});
}

void draw_face(Svg& svg, const Box& box, const Face& face, std::size_t number, Spot corner) {
  const BoxSketch sketch(box, {{corner.x + 20, corner.y + 44}, 240, 180});
  svg.text(corner, fmt::format("{}: {}", number, face.name()), {.size = 15, .bold = true});
  svg.text({corner.x, corner.y + 19},
           fmt::format("{}, {}", face.numbers(),
                       sketch.shows(face) ? "seen from outside" : "seen through the box"),
           {.size = 13, .faint = true});
  sketch.draw_edges(svg, kFaintEdge);
  PathData path;
  for (const std::size_t k : face.corners) {
    path.next(sketch.corner(k));
  }
  svg.path(path.close().data(), "class=\"f5\" fill=\"#56b4e9\" fill-opacity=\"0.3\"");
  for (std::size_t k = 0; k < 4; ++k) {
    draw_arrow(svg, sketch.corner(face.corners[k]), sketch.corner(face.corners[(k + 1) % 4]));
  }
  for (const std::size_t k : face.corners) {
    draw_number(svg, k, sketch.corner(k));
  }
}

/// \errors std::logic_error where the faces do not close around the box.
void check_faces(const Box& box) {
  const Mesh mesh = mesh_of(box, faces());
  require(find_defects(mesh).closed() && enclosed(mesh) == volume(box),
          "the faces of figure 4.12 and the box");
}

}  // namespace

Result figure_4_9(const Context&) {
  const ToySet set = space_toy_set();
  const auto all = corners(bounds(set.mesh));
  Table table{.id = "figure_4_9_corners",
              .caption = fmt::format("Corners of the box of \"{}\": which of its two points gives "
                                     "each coordinate.",
                                     set.title),
              .columns = {{"from_x"}, {"from_y"}, {"from_z"}, {"x"}, {"y"}, {"z"}}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    table.rows.push_back({word_cell(side_of(k, 0)), word_cell(side_of(k, 1)),
                          word_cell(side_of(k, 2)), all[k].x, all[k].y, all[k].z});
  }
  const auto label = [&](Svg& svg, std::size_t k, Spot at) {
    const bool given = k == 0 || k == 7;
    svg.circle(at, given ? 6 : 3.5, "class=\"f1\" fill=\"#d55e00\"");
    const double y = side_of(k, 2) == "least" ? at.y + 22 : at.y - 12;
    const std::string_view name = k == 0 ? "least " : k == 7 ? "greatest " : "";
    svg.text({at.x, y}, fmt::format("{}{}", name, point_words(all[k])),
             {.size = 14, .anchor = Anchor::middle, .bold = given, .haloed = true});
  };
  Result result;
  result.figures = {
      {.id = "figure_4_9",
       .caption = "The coordinates of a box: its least and its greatest point, from "
                  "which all eight corners follow. Drawn from the caption.",
       .svg = draw_corners("The coordinates of a box",
                           "Four triangles in space and their box; z is up", set, label),
       .alt = "A box around four triangles with the coordinates of its corners."}};
  result.tables = {std::move(table)};
  return result;
}

Result figure_4_10(const Context&) {
  const ToySet set = space_toy_set();
  const auto all = corners(bounds(set.mesh));
  Table table{.id = "figure_4_10_numbers",
              .caption =
                  "Numbers of the corners: each is the sum of 1, 2 and 4 for the greatest "
                  "x, y and z; edges join corners whose numbers differ by one of these.",
              .columns = {{"number"}, {"binary"}, {"x"}, {"y"}, {"z"}, {"edges_to"}}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    table.rows.push_back({count_cell(k), word_cell(fmt::format("{:03b}", k)), all[k].x, all[k].y,
                          all[k].z, word_cell(fmt::format("{} {} {}", k ^ 1U, k ^ 2U, k ^ 4U))});
  }
  const auto label = [&](Svg& svg, std::size_t k, Spot at) {
    draw_number(svg, k, at);
    const double y = side_of(k, 2) == "least" ? at.y + 27 : at.y - 17;
    svg.text({at.x, y}, fmt::format("{:03b}", k),
             {.size = 13, .anchor = Anchor::middle, .faint = true, .haloed = true});
  };
  Result result;
  result.figures = {
      {.id = "figure_4_10",
       .caption = "Numbers of the corners of a box, from which its faces are drawn: "
                  "1 for the greatest x, 2 for the greatest y, 4 for the greatest z. "
                  "The numbers are ours; those of the thesis were not available to us.",
       .svg = draw_corners("The numbers of a box's corners",
                           "Below or above each number: in binary, bits zyx", set, label),
       .alt = "A box whose corners have the numbers 0 to 7."}};
  result.tables = {std::move(table)};
  return result;
}

Result figure_4_11(const Context&) {
  const Box box = bounds(space_toy_set().mesh);
  check_faces(box);
  const BoxSketch sketch(box, {{0, 0}, 100, 100});
  Table steps{.id = "figure_4_11_faces",
              .caption =
                  "The faces that the listing draws: their corners counter-clockwise as "
                  "seen from outside, and which the reader of figure 4.12 sees from there.",
              .columns = {{"face"}, {"side"}, {"corners"}, {"seen_from_outside"}}};
  for (const Face& face : faces()) {
    steps.rows.push_back({count_cell(steps.rows.size() + 1), word_cell(face.name()),
                          word_cell(face.numbers()), yes_cell(sketch.shows(face))});
  }
  return listing_result(
      "figure_4_11",
      "Drawing a box by its numbered corners, and the faces that a run gives. Its twelve triangles "
      "close, face outward and enclose the volume of the box.",
      {.title = "How a box is drawn",
       .lines = {{0, "draw (least, greatest):"},
                 {1, "for corner = 0 to 7:"},
                 {2, "take the greatest x, y, z for the bits 1, 2, 4, else the least"},
                 {1, "for each axis z, y, x:"},
                 {2, "a, b = the bits of the next two axes in turn"},
                 {2, "draw the corners 0, b, a + b, a"},
                 {2, "c = the bit of the axis"},
                 {2, "draw the corners c, c + a, c + a + b, c + b"}},
       .heading = "the faces by number of corner"},
      std::move(steps));
}

Result figure_4_12(const Context&) {
  const Box box = bounds(space_toy_set().mesh);
  check_faces(box);
  const auto all = corners(box);
  const std::string title = "The six faces of a box, each with the order of its corners";
  Table table{.id = "figure_4_12_corners",
              .caption = "The 24 corners in the order in which the six faces read them.",
              .columns = {{"call"}, {"face"}, {"side"}, {"corner"}, {"x"}, {"y"}, {"z"}}};
  Svg svg(960, 620, title);
  svg.text({20, 30}, title, {.size = 17, .bold = true});
  std::uint64_t seen = 0;
  std::size_t number = 0;
  for (const Face& face : faces()) {
    const std::size_t row = number / 3;
    const Spot place{30 + 315 * static_cast<double>(number % 3),
                     74 + 275 * static_cast<double>(row)};
    draw_face(svg, box, face, ++number, place);
    seen += BoxSketch(box, {{0, 0}, 1, 1}).shows(face) ? 1U : 0U;
    for (const std::size_t k : face.corners) {
      table.rows.push_back({count_cell(table.rows.size() + 1), count_cell(number),
                            word_cell(face.name()), count_cell(k), all[k].x, all[k].y, all[k].z});
    }
  }
  Result result;
  result.figures = {
      {.id = "figure_4_12",
       .caption =
           "Six quadrilaterals and the order in which each reads its corners (GL_QUADS takes "
           "four calls of glVertex3f a face). Drawn from the caption with our numbers of "
           "figure 4.10; the order of the thesis was not available to us.",
       .svg = svg.document(),
       .alt = "Six pictures of one box; in each a face is filled and arrows run around it."}};
  result.tables = {std::move(table)};
  result.remarks = {fmt::format(
      "The order is counter-clockwise as seen from outside, so that a graphics library can leave "
      "out the faces that look away: here {} of 6 are seen from outside. Each edge is read by two "
      "faces in opposite directions.",
      seen)};
  return result;
}

}  // namespace soms::reproduce
