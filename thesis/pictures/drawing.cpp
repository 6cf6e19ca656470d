#include "thesis/pictures/drawing.h"

#include "apps/draw/axis.h"
#include "apps/draw/svg.h"
#include "thesis/pictures/projection.h"
#include "thesis/trees/facet_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace soms::reproduce {

namespace {

constexpr double kDrawingWidth = 720;
constexpr double kDrawingMargin = 14;
constexpr double kGap = 18;
constexpr double kDrawingTitleSize = 18;
constexpr double kTextSize = 14;
constexpr double kNoteSize = 13;
constexpr double kKeyRow = 24;
/// Rim of a panel's picture, so that lines and dots at its edge are whole.
constexpr double kRim = 8;
constexpr double kLongestSide = 90;
constexpr double kAmbient = 0.42;
/// Bytes that a box takes, about.
constexpr std::size_t kBoxBytes = 300;
/// With more boxes their hidden edges only confuse.
constexpr std::size_t kMostHiddenEdges = 16;

std::string fill_attributes(int color) {
  if (color >= 0) {
    const auto k = static_cast<std::size_t>(color) % kSeriesColors;
    return fmt::format("class=\"f{}\" fill=\"{}\"", k, series_color(k));
  }
  return fmt::format("fill=\"{}\"", shade_of(color, 0.95));
}

std::string stroke_attributes(int color) {
  if (color >= 0) {
    const auto k = static_cast<std::size_t>(color) % kSeriesColors;
    return fmt::format("class=\"s{}\" stroke=\"{}\"", k, series_color(k));
  }
  return fmt::format("stroke=\"{}\"", shade_of(color, 0.95));
}

PageBounds bounds_of(std::span<const Panel> panels, const look::CameraFrame& from) {
  PageBounds frame;
  for (const Panel& panel : panels) {
    for (const DrawnMesh& drawn : panel.meshes) {
      for (const auto& triangle : drawn.mesh->triangles) {
        for (const std::uint32_t vertex : triangle) {
          frame.take(from.on_page(drawn.mesh->vertices[vertex] + drawn.shift));
        }
      }
    }
    for (const DrawnBox& drawn : panel.boxes) {
      if (!drawn.box.empty()) {
        frame.take(from, drawn.box);
      }
    }
    for (const DrawnPlane& plane : panel.planes) {
      frame.take(from, plane.within);
    }
    for (const DrawnPoint& point : panel.points) {
      frame.take(from.on_page(point.at));
    }
  }
  return frame.left > frame.right ? PageBounds{0, 0, 1, 1} : frame;
}

Vec3 normal_of(const Triangle& t) {
  return cross(t.b - t.a, t.c - t.a);
}

/// What each panel shows: the same part of the page for all, or each its own.
std::vector<PageBounds> frames_of(const Drawing& drawing, const look::CameraFrame& from) {
  if (drawing.same_scale) {
    return std::vector<PageBounds>(drawing.panels.size(), bounds_of(drawing.panels, from));
  }
  std::vector<PageBounds> frames;
  for (const Panel& panel : drawing.panels) {
    frames.push_back(bounds_of({&panel, 1}, from));
  }
  return frames;
}

/// Places panels on the page and draws them.
class Board {
 public:
  explicit Board(const Drawing& drawing)
      : drawing_(drawing),
        from_(frame_of(drawing.view)),
        frames_(frames_of(drawing, from_)),
        columns_(std::max(1, std::min(drawing.columns, static_cast<int>(drawing.panels.size())))),
        panel_width_((kDrawingWidth - 2 * kDrawingMargin - kGap * (columns_ - 1)) / columns_),
        picture_height_(tallest() + 2 * kRim),
        title_(wrapped(drawing.title, kDrawingTitleSize, kDrawingWidth - 2 * kDrawingMargin, true)),
        svg_(kDrawingWidth, page_height(), drawing.title) {}

  std::string draw() {
    svg_.lines({kDrawingMargin, kDrawingMargin + 0.9 * kDrawingTitleSize}, title_,
               {.size = kDrawingTitleSize, .bold = true});
    draw_keys();
    for (std::size_t k = 0; k < drawing_.panels.size(); ++k) {
      draw_panel(drawing_.panels[k], k);
    }
    return svg_.document();
  }

 private:
  static constexpr double kTallest = 560;

  /// Pixels a unit.
  [[nodiscard]] double scale_of(const PageBounds& frame) const {
    return std::min(panel_width_ - 2 * kRim, kTallest * (frame.width() / frame.height())) /
           frame.width();
  }

  [[nodiscard]] double tallest() const {
    double height = 0;
    for (const PageBounds& frame : frames_) {
      height = std::max(height, frame.height() * scale_of(frame));
    }
    return height;
  }

  [[nodiscard]] double title_height() const {
    const auto lines = static_cast<double>(title_.size());
    return kDrawingMargin + (drawing_.title.empty() ? 0 : 1.25 * kDrawingTitleSize * lines) + 6;
  }

  [[nodiscard]] std::vector<Spot> key_spots() const {
    std::vector<Spot> spots;
    Spot next{kDrawingMargin, title_height()};
    for (const Key& key : drawing_.keys) {
      const double width = text_width(key.words, kTextSize) + 40;
      if (next.x > kDrawingMargin && next.x + width > kDrawingWidth - kDrawingMargin) {
        next = {kDrawingMargin, next.y + kKeyRow};
      }
      spots.push_back(next);
      next.x += width;
    }
    return spots;
  }

  [[nodiscard]] double panels_top() const {
    return drawing_.keys.empty() ? title_height() : key_spots().back().y + kKeyRow + 4;
  }

  [[nodiscard]] std::vector<std::string> title_lines(const Panel& panel) const {
    return wrapped(panel.title, kTextSize, panel_width_, true);
  }

  [[nodiscard]] std::vector<std::string> note_lines(const Panel& panel) const {
    if (panel.note.empty()) {
      return {};
    }
    return wrapped(panel.note, kNoteSize, panel_width_);
  }

  /// Height of a row of panels: words above, picture, words below.
  struct Row {
    double above = 0;
    double all = 0;
  };

  [[nodiscard]] Row row_of(std::size_t row) const {
    Row heights;
    double below = 0;
    const auto columns = static_cast<std::size_t>(columns_);
    for (std::size_t k = row * columns; k < std::min((row + 1) * columns, drawing_.panels.size());
         ++k) {
      const Panel& panel = drawing_.panels[k];
      const auto titles = static_cast<double>(panel.title.empty() ? 0 : title_lines(panel).size());
      heights.above = std::max(heights.above, 1.25 * kTextSize * titles + 4);
      below = std::max(below, 1.25 * kNoteSize * static_cast<double>(note_lines(panel).size()) + 4);
    }
    heights.all = heights.above + picture_height_ + below + kGap;
    return heights;
  }

  [[nodiscard]] double row_top(std::size_t row) const {
    double top = panels_top();
    for (std::size_t k = 0; k < row; ++k) {
      top += row_of(k).all;
    }
    return top;
  }

  [[nodiscard]] double page_height() const {
    const auto columns = static_cast<std::size_t>(columns_);
    return row_top((drawing_.panels.size() + columns - 1) / columns) - kGap + kDrawingMargin;
  }

  void draw_keys() {
    const std::vector<Spot> spots = key_spots();
    for (std::size_t k = 0; k < drawing_.keys.size(); ++k) {
      const Key& key = drawing_.keys[k];
      draw_key(key, spots[k]);
      svg_.text({spots[k].x + 28, spots[k].y + 13}, key.words, {.size = kTextSize});
    }
  }

  void draw_key(const Key& key, Spot at) {
    const std::string stroke = stroke_attributes(key.color);
    switch (key.kind) {
      case KeyKind::fill:
        svg_.rect({at.x, at.y + 1}, 22, 14, fill_attributes(key.color));
        break;
      case KeyKind::point:
        svg_.circle({at.x + 11, at.y + 8}, 4.5, fill_attributes(key.color));
        break;
      case KeyKind::plane:
        svg_.line({at.x + 11, at.y - 1}, {at.x + 11, at.y + 17}, stroke + " stroke-width=\"3\"");
        break;
      case KeyKind::box:
      case KeyKind::dashed_box:
        svg_.rect({at.x + 1, at.y + 2}, 20, 12,
                  fmt::format("fill=\"none\" {} stroke-width=\"2\"{}", stroke,
                              key.kind == KeyKind::box ? "" : " stroke-dasharray=\"4 3\""));
        break;
    }
  }

  /// Place on the page of what is seen, in the panel that is being drawn.
  [[nodiscard]] Vec3 place(const Vec3& point) const {
    const Vec3 seen = from_.on_page(point);
    return {(seen.x - frame_.left) * scale_ + indent_.x, (seen.y - frame_.top) * scale_ + indent_.y,
            seen.z * scale_};
  }

  [[nodiscard]] Spot spot(const Vec3& point) const {
    const Vec3 seen = place(point);
    return {origin_.x + seen.x, origin_.y + seen.y};
  }

  void draw_panel(const Panel& panel, std::size_t number) {
    const auto columns = static_cast<std::size_t>(columns_);
    const Row row = row_of(number / columns);
    const double left =
        kDrawingMargin + (panel_width_ + kGap) * static_cast<double>(number % columns);
    const double top = row_top(number / columns);
    if (!panel.title.empty()) {
      svg_.lines({left, top + kTextSize}, title_lines(panel), {.size = kTextSize, .bold = true});
    }
    origin_ = {left, top + row.above};
    frame_ = frames_[number];
    scale_ = scale_of(frame_);
    // Small pictures stand in the middle of their panel.
    indent_ = {(panel_width_ - frame_.width() * scale_) / 2,
               (picture_height_ - frame_.height() * scale_) / 2};
    for (const DrawnPlane& plane : panel.planes) {
      draw_plane(plane);
    }
    draw_meshes(panel);
    draw_boxes(panel);
    for (const DrawnPoint& point : panel.points) {
      svg_.circle(spot(point.at), 4,
                  fill_attributes(point.color) + " stroke=\"#fff\" stroke-width=\"1\"");
    }
    svg_.lines({left, origin_.y + picture_height_ + kNoteSize}, note_lines(panel),
               {.size = kNoteSize, .faint = true});
  }

  void draw_plane(const DrawnPlane& plane) {
    Box sheet = plane.within;
    sheet.lower[plane.axis] = plane.value;
    sheet.upper[plane.axis] = plane.value;
    const std::array<Vec3, 8> all = corners(sheet);
    // The four corners in turn: two bits of the axes that the sheet spans.
    const unsigned a = 1U << ((plane.axis + 1) % 3);
    const unsigned b = 1U << ((plane.axis + 2) % 3);
    PathData path;
    for (const unsigned k : {0U, a, a | b, b}) {
      path.next(spot(all[k]));
    }
    svg_.path(path.close().data(),
              fmt::format("{} fill-opacity=\".16\" stroke=\"{}\" stroke-width=\"2.5\" "
                          "stroke-linejoin=\"round\"",
                          fill_attributes(plane.color),
                          series_color(static_cast<std::size_t>(std::max(0, plane.color)))));
  }

  [[nodiscard]] std::vector<Facet> facets_of(const Panel& panel) const {
    std::vector<Facet> facets;
    for (const DrawnMesh& drawn : panel.meshes) {
      for (std::size_t k = 0; k < drawn.mesh->triangles.size(); ++k) {
        const Triangle triangle = drawn.mesh->triangle(static_cast<TriangleId>(k));
        Facet facet;
        facet.corners = {place(triangle.a + drawn.shift), place(triangle.b + drawn.shift),
                         place(triangle.c + drawn.shift)};
        facet.brightness =
            is_flat(from_) ? 1
                           : look::brightness(from_, normal_of(triangle), from_.forward, kAmbient);
        facet.color = drawn.colors.empty() ? drawn.color : drawn.colors[k];
        facets.push_back(facet);
      }
    }
    return facets;
  }

  void draw_meshes(const Panel& panel) {
    std::vector<Facet> facets = facets_of(panel);
    if (facets.empty()) {
      return;
    }
    if (!is_flat(from_)) {
      cut_long(facets, kLongestSide);
    }
    keep_visible(facets, panel_width_, picture_height_);
    const std::size_t share = drawing_.budget / drawing_.panels.size();
    const std::size_t boxes = std::min(share / 2, kBoxBytes * panel.boxes.size());
    const std::size_t all = facets.size();
    const FittedPaths fitted = paths_within(std::move(facets), share - boxes);
    write_paths(fitted);
    if (fitted.drawn < all) {
      svg_.text({origin_.x, origin_.y + picture_height_ - 2},
                fmt::format("{} of {} visible pieces drawn",
                            number_label(static_cast<double>(fitted.drawn)),
                            number_label(static_cast<double>(all))),
                {.size = 11, .faint = true, .haloed = true});
    }
  }

  void write_paths(const FittedPaths& fitted) {
    const bool dense = fitted.drawn > 1500;
    svg_.open_group(
        fmt::format("transform=\"translate({}) scale(.1)\" stroke=\"#000\" "
                    "stroke-opacity=\"{}\" stroke-width=\"{}\" "
                    "stroke-linejoin=\"round\"",
                    pixels(origin_), dense ? ".2" : ".35", dense ? 3 : 5));
    for (const FacetPath& path : fitted.paths) {
      std::string look = fmt::format("fill=\"{}\"", path.fill);
      if (!path.outlined) {
        look += fmt::format(" stroke=\"{}\" stroke-opacity=\"1\"", path.fill);
      }
      svg_.path(path.data, look);
    }
    svg_.close_group();
  }

  void draw_boxes(const Panel& panel) {
    std::vector<const DrawnBox*> order;
    double nearest = 1e300;
    double farthest = -1e300;
    const auto depth = [&](const DrawnBox* drawn) { return from_.on_page(drawn->box.center()).z; };
    for (const DrawnBox& drawn : panel.boxes) {
      if (!drawn.box.empty()) {
        order.push_back(&drawn);
        nearest = std::min(nearest, depth(&drawn));
        farthest = std::max(farthest, depth(&drawn));
      }
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](const DrawnBox* a, const DrawnBox* b) { return depth(a) > depth(b); });
    const double width = order.size() > 40 ? 0.9 : order.size() > 12 ? 1.3 : 2;
    svg_.open_group(
        fmt::format("fill=\"none\" stroke-width=\"{}\" stroke-linejoin=\"round\"", pixels(width)));
    for (const DrawnBox* drawn : order) {
      const double share = farthest > nearest && !is_flat(from_)
                               ? (depth(drawn) - nearest) / (farthest - nearest)
                               : 0;
      draw_box(*drawn,
               fmt::format("{} stroke-opacity=\"{:.2f}\"", stroke_attributes(drawn->color),
                           0.95 - 0.5 * share),
               order.size() <= kMostHiddenEdges);
    }
    svg_.close_group();
  }

  void draw_box(const DrawnBox& drawn, const std::string& attributes, bool with_hidden) {
    const std::array<Vec3, 8> all = corners(drawn.box);
    const std::string_view dashes = drawn.dashed ? " stroke-dasharray=\"5 4\"" : "";
    if (is_flat(from_)) {
      PageBounds frame;
      for (const Vec3& corner : all) {
        frame.take(place(corner));
      }
      svg_.rect({origin_.x + frame.left, origin_.y + frame.top}, frame.right - frame.left,
                frame.bottom - frame.top, fmt::format("{}{}", attributes, dashes));
      return;
    }
    std::array<Spot, 8> spots;
    std::transform(all.begin(), all.end(), spots.begin(),
                   [this](const Vec3& corner) { return spot(corner); });
    const BoxEdges edges = edges_of(spots, far_corner(all, from_));
    svg_.path(edges.front.data(), fmt::format("{}{}", attributes, dashes));
    if (with_hidden) {
      svg_.path(edges.hidden.data(), fmt::format("{} stroke-dasharray=\"2 4\"", attributes));
    }
  }

  const Drawing& drawing_;
  look::CameraFrame from_;
  std::vector<PageBounds> frames_;
  int columns_;
  double panel_width_;
  double picture_height_;
  std::vector<std::string> title_;
  Svg svg_;
  // Of the panel that is being drawn:
  Spot origin_;
  PageBounds frame_;
  double scale_ = 1;
  Spot indent_;
};

}  // namespace

std::string draw(const Drawing& drawing) {
  return Board(drawing).draw();
}

}  // namespace soms::reproduce
