#include "apps/view/drawing/ground_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

namespace soms::view {

namespace {

constexpr Color kStreet{190, 190, 187, 255};
constexpr Color kLawn{198, 202, 188, 255};
constexpr Color kSidewalk{214, 213, 208, 255};
constexpr Color kLaneMark{246, 246, 243, 255};

/// Height over the longer side of a flat piece, at most.
constexpr double kFlat = 0.12;
/// Length over the mesh's longer side of a mark, at most: what is longer is a sidewalk.
constexpr double kMarkLength = 0.1;
constexpr std::size_t kHeightCells = 512;

double longer_side(const Box& box) {
  return std::max(box.extent().x, box.extent().y);
}

/// Heights of a sheet on a grid; NaN beside it.
class SheetHeights {
 public:
  explicit SheetHeights(const Box& box)
      : lower_(box.lower), side_(longer_side(box) / kHeightCells) {}

  /// False once triangles have taken more cells than a ground of streets or hills does.
  [[nodiscard]] bool add(const Triangle& t) {
    const double area = (t.b.x - t.a.x) * (t.c.y - t.a.y) - (t.b.y - t.a.y) * (t.c.x - t.a.x);
    if (area == 0) {
      return true;
    }
    const auto [left, right] = std::minmax({t.a.x, t.b.x, t.c.x});
    const auto [low, high] = std::minmax({t.a.y, t.b.y, t.c.y});
    const std::size_t first_i = cell(left - lower_.x);
    const std::size_t last_i = cell(right - lower_.x);
    const std::size_t first_j = cell(low - lower_.y);
    const std::size_t last_j = cell(high - lower_.y);
    const std::size_t cells = (last_i - first_i + 1) * (last_j - first_j + 1);
    if (cells > left_) {
      return false;
    }
    left_ -= cells;
    for (std::size_t j = first_j; j <= last_j; ++j) {
      for (std::size_t i = first_i; i <= last_i; ++i) {
        const double x = lower_.x + side_ * (static_cast<double>(i) + 0.5);
        const double y = lower_.y + side_ * (static_cast<double>(j) + 0.5);
        const double u = ((x - t.a.x) * (t.c.y - t.a.y) - (y - t.a.y) * (t.c.x - t.a.x)) / area;
        const double v = ((t.b.x - t.a.x) * (y - t.a.y) - (t.b.y - t.a.y) * (x - t.a.x)) / area;
        if (u >= 0 && v >= 0 && u + v <= 1) {
          heights_[i + j * kHeightCells] = t.a.z + u * (t.b.z - t.a.z) + v * (t.c.z - t.a.z);
        }
      }
    }
    return true;
  }

  [[nodiscard]] double at(const Vec3& p) const {
    return heights_[cell(p.x - lower_.x) + cell(p.y - lower_.y) * kHeightCells];
  }

  [[nodiscard]] double side() const { return side_; }

 private:
  [[nodiscard]] std::size_t cell(double from) const {
    constexpr double kLast = kHeightCells - 1;
    return static_cast<std::size_t>(std::clamp(std::floor(from / side_), 0.0, kLast));
  }

  Vec3 lower_;
  double side_;
  std::size_t left_ = 64 * kHeightCells * kHeightCells;
  std::vector<double> heights_ =
      std::vector<double>(kHeightCells * kHeightCells, std::numeric_limits<double>::quiet_NaN());
};

std::vector<Box> boxes_of(const Mesh& mesh, const std::vector<std::uint32_t>& pieces) {
  std::vector<Box> boxes;
  for (TriangleId i = 0; i < pieces.size(); ++i) {
    boxes.resize(std::max<std::size_t>(boxes.size(), pieces[i] + std::size_t{1}));
    const Triangle t = mesh.triangle(i);
    for (const Vec3& corner : {t.a, t.b, t.c}) {
      boxes[pieces[i]].grow(corner);
    }
  }
  return boxes;
}

bool is_flat(const Box& box) {
  return box.extent().z <= kFlat * longer_side(box);
}

/// The number of the widest flat piece that is wide enough; that of no piece where there is none.
std::size_t ground_among(const std::vector<Box>& boxes, const Box& all) {
  std::size_t ground = boxes.size();
  double widest = 0.5 * longer_side(all);
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const double width = longer_side(boxes[k]);
    if (is_flat(boxes[k]) && width >= widest) {
      ground = k;
      widest = width;
    }
  }
  return ground;
}

}  // namespace

void color_ground(const Mesh& mesh, const std::vector<std::uint32_t>& pieces,
                  std::vector<Color>& colors) {
  const std::vector<Box> boxes = boxes_of(mesh, pieces);
  const Box all = soms::bounds(mesh);
  const std::size_t ground = ground_among(boxes, all);
  // A plate by itself is a body, and so is a roof.
  if (ground == boxes.size() || boxes[ground].center().z >= all.center().z) {
    return;
  }
  SheetHeights heights(all);
  for (TriangleId i = 0; i < pieces.size(); ++i) {
    if (pieces[i] == ground && !heights.add(mesh.triangle(i))) {
      return;
    }
  }
  std::vector<bool> lies;
  std::transform(boxes.begin(), boxes.end(), std::back_inserter(lies), is_flat);
  for (TriangleId i = 0; i < pieces.size(); ++i) {
    const double near = 0.004 * longer_side(boxes[pieces[i]]) + 0.1 * heights.side();
    const Triangle t = mesh.triangle(i);
    for (const Vec3& corner : {t.a, t.b, t.c}) {
      // NaN, beside the ground, fails too.
      const bool is_low = std::abs(corner.z - heights.at(corner)) <= near;
      lies[pieces[i]] = lies[pieces[i]] && is_low;
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i] == ground) {
      colors[i] = kStreet;
    } else if (lies[pieces[i]]) {
      const double share = longer_side(boxes[pieces[i]]) / longer_side(all);
      colors[i] = share > kMarkLength ? kSidewalk : kLaneMark;
    }
  }
}

void color_named_ground(const Mesh& mesh, std::vector<Color>& colors) {
  constexpr std::array<std::pair<std::string_view, Color>, 4> kNames{{{"terrain", kLawn},
                                                                      {"roads", kStreet},
                                                                      {"sidewalks", kSidewalk},
                                                                      {"lane marks", kLaneMark}}};
  for (const Part& part : mesh.parts) {
    for (const auto& [word, color] : kNames) {
      if (part.name == word) {
        std::fill_n(colors.begin() + static_cast<std::ptrdiff_t>(part.first), part.count, color);
      }
    }
  }
}

}  // namespace soms::view
