#include "apps/view/sight/dense_place.h"

#include "apps/view/sight/rich_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace soms::view {

namespace {

constexpr std::size_t kCellsOfPlace = 256;     ///< along a side of the grid
constexpr std::size_t kWindow = 12;            ///< likewise of a place
constexpr double kSparse = 0.02;               ///< of the cells; more are a city as any
constexpr std::uint32_t kMover = 4;            ///< what it counts, in cells of surface
constexpr std::uint32_t kTouching = 40;        ///< likewise a mover that touches something
constexpr std::uint64_t kFewTriangles = 1000;  ///< which are a model, not a city

/// The city from above.
class CellGrid {
 public:
  explicit CellGrid(const Box& all)
      : low_(all.lower), side_(std::max(all.extent().x, all.extent().y) / kCellsOfPlace) {}

  [[nodiscard]] std::size_t cell(double along, double low) const {
    const double at = std::floor((along - low) / side_);
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(kCellsOfPlace - 1)));
  }

  [[nodiscard]] std::array<std::size_t, 2> cell_of(const Vec3& p) const {
    return {cell(p.x, low_.x), cell(p.y, low_.y)};
  }

  /// Marks all cells that a box reaches; false once there are too many for a sparse city.
  [[nodiscard]] bool mark(const Box& box) {
    const auto [x0, y0] = cell_of(box.lower);
    const auto [x1, y1] = cell_of(box.upper);
    if (static_cast<double>((x1 - x0 + 1) * (y1 - y0 + 1)) > kMost) {
      return false;
    }
    for (std::size_t y = y0; y <= y1; ++y) {
      for (std::size_t x = x0; x <= x1; ++x) {
        marked_ += weights_[y * kCellsOfPlace + x] == 0 ? 1U : 0U;
        weights_[y * kCellsOfPlace + x] = 1;
      }
    }
    return static_cast<double>(marked_) <= kMost;
  }

  void add(const Vec3& p, std::uint32_t weight) {
    const auto [x, y] = cell_of(p);
    weights_[y * kCellsOfPlace + x] += weight;
  }

  /// The lower cell of the window of greatest weight, the first of equal ones.
  [[nodiscard]] std::array<std::size_t, 2> heaviest() const {
    std::vector<std::uint64_t> sums((kCellsOfPlace + 1) * (kCellsOfPlace + 1),
                                    0);  // of all cells before
    const auto sum = [&](std::size_t x, std::size_t y) -> std::uint64_t& {
      return sums[y * (kCellsOfPlace + 1) + x];
    };
    for (std::size_t y = 0; y < kCellsOfPlace; ++y) {
      for (std::size_t x = 0; x < kCellsOfPlace; ++x) {
        sum(x + 1, y + 1) =
            weights_[y * kCellsOfPlace + x] + sum(x, y + 1) + sum(x + 1, y) - sum(x, y);
      }
    }
    std::array<std::size_t, 2> best{};
    std::uint64_t most = 0;
    for (std::size_t y = 0; y + kWindow <= kCellsOfPlace; ++y) {
      for (std::size_t x = 0; x + kWindow <= kCellsOfPlace; ++x) {
        const std::uint64_t here =
            sum(x + kWindow, y + kWindow) + sum(x, y) - sum(x + kWindow, y) - sum(x, y + kWindow);
        if (here > most) {
          most = here;
          best = {x, y};
        }
      }
    }
    return best;
  }

 private:
  static constexpr double kMost = kSparse * kCellsOfPlace * kCellsOfPlace;

  Vec3 low_;
  double side_;
  std::vector<std::uint32_t> weights_ =
      std::vector<std::uint32_t>(kCellsOfPlace * kCellsOfPlace, 0);
  std::size_t marked_ = 0;
};

/// Calls `take` with the bounds of each triangle of the city, until it says no.
template <class Take>
bool for_each_triangle(const ViewScene& scene, const Take& take) {
  for (std::uint32_t k = 0; k < scene.city_parts(); ++k) {
    const std::size_t count = scene.body(city_part(k)).shape.mesh().triangles.size();
    for (TriangleId i = 0; i < count; ++i) {
      if (!take(bounds(scene.triangle(city_part(k), i)))) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

std::optional<DensePlace> dense_place(const ViewScene& scene) {
  std::uint64_t triangles = 0;
  for (std::uint32_t k = 0; k < scene.city_parts(); ++k) {
    triangles += scene.body(city_part(k)).shape.mesh().triangles.size();
  }
  const Box all = scene.bounds();
  if (scene.city_parts() == 0 || triangles < kFewTriangles || all.empty() ||
      !(std::max(all.extent().x, all.extent().y) > 0)) {
    return std::nullopt;
  }
  CellGrid grid(all);
  if (!for_each_triangle(scene, [&](const Box& box) { return grid.mark(box); })) {
    return std::nullopt;
  }
  const std::set<std::uint32_t> touching = touching_movers(scene.contacts());
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
    const Vec3 at = scene.bounds(mover(k)).center();
    if (all.contains({at, at})) {
      grid.add(at, touching.contains(k) ? kTouching : kMover);
    }
  }
  const auto low = grid.heaviest();
  const auto is_there = [&](const Vec3& p) {
    const auto cell = grid.cell_of(p);
    return cell[0] >= low[0] && cell[0] < low[0] + kWindow && cell[1] >= low[1] &&
           cell[1] < low[1] + kWindow;
  };
  DensePlace place;
  for_each_triangle(scene, [&](const Box& box) {
    if (is_there(box.center())) {
      place.box.grow(box);
    } else {
      ++place.triangles_left;
    }
    return true;
  });
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
    const Box box = scene.bounds(mover(k));
    if (is_there(box.center()) && all.contains({box.center(), box.center()})) {
      place.box.grow(box);
    } else {
      ++place.movers_left;
    }
  }
  return place.triangles_left > 0 && !place.box.empty() ? std::optional(place) : std::nullopt;
}

}  // namespace soms::view
