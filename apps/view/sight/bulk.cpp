#include "apps/view/sight/bulk.h"

#include "apps/view/scene/scene_colors.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace soms::view {

namespace {

constexpr std::size_t kLeastPieces = 20;
constexpr std::size_t kOneOfPieces = 20;
constexpr double kBeyond = 0.5;  ///< of the extent of the middle nine tenths

/// Bounds of the pieces of all bodies of a city.
std::vector<Box> boxes_of_pieces(const ViewScene& scene) {
  std::vector<Box> boxes;
  for (std::uint32_t k = 0; k < scene.city_parts(); ++k) {
    const MeshView& mesh = scene.body(city_part(k)).shape.mesh();
    const Mesh& whole = *scene.body(city_part(k)).shape.shared_mesh();
    const std::vector<std::uint32_t> pieces =
        whole.parts.size() > 1 ? parts_of_triangles(whole) : pieces_of_triangles(whole);
    std::map<std::uint32_t, Box> of_piece;
    for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle t = scene.triangle(city_part(k), i);
      Box& box = of_piece[pieces[i]];
      box.grow(t.a);
      box.grow(t.b);
      box.grow(t.c);
    }
    for (const auto& [piece, box] : of_piece) {
      boxes.push_back(box);
    }
  }
  return boxes;
}

/// Where the middle nine tenths of some numbers lie, with as much again on either side as counts
/// as near.
std::pair<double, double> near_range(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  const std::size_t few = numbers.size() / kOneOfPieces;
  const double low = numbers[few];
  const double high = numbers[numbers.size() - 1 - few];
  const double room = kBeyond * (high - low);
  return {low - room, high + room};
}

}  // namespace

std::optional<CityBulk> city_bulk(const ViewScene& scene) {
  const std::vector<Box> boxes = boxes_of_pieces(scene);
  if (boxes.size() < kLeastPieces) {
    return std::nullopt;
  }
  std::vector<double> x;
  std::vector<double> y;
  for (const Box& box : boxes) {
    x.push_back(box.center().x);
    y.push_back(box.center().y);
  }
  const auto [west, east] = near_range(x);
  const auto [south, north] = near_range(y);
  CityBulk bulk;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const bool is_near = west <= x[k] && x[k] <= east && south <= y[k] && y[k] <= north;
    if (is_near) {
      bulk.box.grow(boxes[k]);
    } else {
      ++bulk.pieces_left;
    }
  }
  const bool few_left = bulk.pieces_left * kOneOfPieces <= boxes.size();
  return bulk.pieces_left > 0 && few_left ? std::optional(bulk) : std::nullopt;
}

}  // namespace soms::view
