#include "apps/view/drawing/tiles.h"

#include "apps/view/drawing/stand_in.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace soms::view {

namespace {

using Order = std::vector<std::uint32_t>;

/// A tile of fewer triangles has no stand-in.
constexpr std::size_t kLeastOfStandIn = 200;

struct Run {
  std::size_t first;
  std::size_t count;
  std::size_t tiles;
};

Vec3 center(const Mesh& mesh, std::uint32_t i) {
  const Triangle t = mesh.triangle(i);
  // Halves and quarters, since sums of coordinates near the limit must stay finite as differences.
  return (t.a * 0.25 + t.b * 0.25) + t.c * 0.5;
}

std::size_t longest_axis(const Box& box) {
  const Vec3 e = box.extent();
  return e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
}

// Splits a run in two at a median, in shares of the tiles that each half becomes.
std::array<Run, 2> split(const Mesh& mesh, Order& order, const Run& run) {
  const auto begin = order.begin() + static_cast<std::ptrdiff_t>(run.first);
  const auto end = begin + static_cast<std::ptrdiff_t>(run.count);
  Box centers;
  std::for_each(begin, end, [&](std::uint32_t i) { centers.grow(center(mesh, i)); });
  const std::size_t axis = longest_axis(centers);
  const std::size_t tiles = run.tiles / 2;
  const std::size_t count = run.count * tiles / run.tiles;
  std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(count), end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double x = center(mesh, a)[axis];
                     const double y = center(mesh, b)[axis];
                     return x < y || (x == y && a < b);
                   });
  return {Run{run.first, count, tiles},
          Run{run.first + count, run.count - count, run.tiles - tiles}};
}

std::vector<Run> runs_of(const Mesh& mesh, Order& order, const TileOptions& options,
                         const Limits& limits) {
  const std::size_t count = order.size();
  const std::size_t wanted = (count + options.triangles - 1) / std::max(options.triangles, 1U);
  std::vector<Run> open{
      {0, count, std::clamp<std::size_t>(wanted, 1, std::max(options.most_tiles, 1U))}};
  std::vector<Run> done;
  while (!open.empty()) {
    const Run run = open.back();
    open.pop_back();
    if (run.tiles == 1) {
      done.push_back(run);
      continue;
    }
    check_stop(limits);
    const auto halves = split(mesh, order, run);
    open.push_back(halves[1]);
    open.push_back(halves[0]);
  }
  return done;
}

// Class of a triangle's size: one more for each four times that its longest side grows.
int size_class(const Triangle& t) {
  const Vec3 e = bounds(t).extent();
  const double side = std::max({e.x, e.y, e.z});
  return side > 0 ? std::ilogb(side) >> 1 : std::numeric_limits<int>::min() / 2;
}

void put_large_first(const Mesh& mesh, std::span<std::uint32_t> order) {
  // In the order of the file within a class: neighbors share vertices.
  std::sort(order.begin(), order.end());
  std::vector<std::pair<int, std::uint32_t>> keyed;
  keyed.reserve(order.size());
  for (const std::uint32_t i : order) {
    keyed.emplace_back(-size_class(mesh.triangle(i)), i);
  }
  std::sort(keyed.begin(), keyed.end());
  std::transform(keyed.begin(), keyed.end(), order.begin(), [](const auto& k) { return k.second; });
}

// Gives out the vertices of one tile after the other; a vertex is shared by triangles of one color.
class VertexWriter {
 public:
  VertexWriter(const Mesh& mesh, std::span<const Color> colors, TiledMesh& result)
      : mesh_(mesh), colors_(colors), result_(result), known_(mesh.vertices.size(), kNone) {}

  void write(const Tile& tile, std::span<const std::uint32_t> order) {
    const auto start = static_cast<std::uint32_t>(result_.vertices.size());
    for (const std::uint32_t i : order) {
      const Color color = colors_.empty() ? Color{} : colors_[i];
      for (const std::uint32_t v : mesh_.triangles[i]) {
        result_.indices.push_back(index_of(v, color, start, tile));
      }
    }
  }

  /// The coarse copy of the tile that was written last; it is kept for `finish`.
  void write_stand_in(Tile& tile, std::span<const StandInTriangle> triangles) {
    tile.stand_in_first = static_cast<std::uint32_t>(stand_ins_.size() / 3);
    tile.stand_in_count = static_cast<std::uint32_t>(triangles.size());
    for (const StandInTriangle& triangle : triangles) {
      const Color color = colors_.empty() ? Color{} : colors_[triangle.of];
      for (const Vec3& corner : {triangle.corners.a, triangle.corners.b, triangle.corners.c}) {
        stand_ins_.push_back(static_cast<std::uint32_t>(result_.vertices.size()));
        result_.vertices.push_back(vertex(corner, color, tile));
      }
    }
  }

  /// Puts the stand-ins behind all triangles.
  void finish() {
    const auto before = static_cast<std::uint32_t>(result_.indices.size() / 3);
    for (Tile& tile : result_.tiles) {
      tile.stand_in_first += before;
    }
    result_.indices.insert(result_.indices.end(), stand_ins_.begin(), stand_ins_.end());
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  static TileVertex vertex(const Vec3& place, Color color, const Tile& tile) {
    const Vec3 d = (place - tile.origin) * (1 / tile.scale);
    return {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z), color};
  }

  std::uint32_t index_of(std::uint32_t v, Color color, std::uint32_t start, const Tile& tile) {
    std::uint32_t& known = known_[v];
    if (known == kNone || known < start || !(result_.vertices[known].color == color)) {
      known = static_cast<std::uint32_t>(result_.vertices.size());
      result_.vertices.push_back(vertex(mesh_.vertices[v], color, tile));
    }
    return known;
  }

  const Mesh& mesh_;
  std::span<const Color> colors_;
  TiledMesh& result_;
  std::vector<std::uint32_t> known_;
  std::vector<std::uint32_t> stand_ins_;  // indices
};

Tile make_tile(const Mesh& mesh, const Run& run, std::span<const std::uint32_t> order) {
  Tile tile;
  for (const std::uint32_t i : order) {
    tile.bounds.grow(bounds(mesh.triangle(i)));
  }
  tile.origin = tile.bounds.center();
  const Vec3 e = tile.bounds.extent();
  const double half = 0.5 * std::max({e.x, e.y, e.z});
  tile.scale = half >= std::numeric_limits<double>::min() ? half : 1;
  tile.first = static_cast<std::uint32_t>(run.first);
  tile.count = static_cast<std::uint32_t>(run.count);
  return tile;
}

}  // namespace

TiledMesh cut_in_tiles(const Mesh& mesh, std::span<const Color> colors, const TileOptions& options,
                       const Limits& limits) {
  TiledMesh result;
  if (mesh.triangles.empty()) {
    return result;
  }
  Order order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  const std::vector<Run> runs = runs_of(mesh, order, options, limits);
  result.vertices.reserve(mesh.vertices.size());
  result.indices.reserve(3 * order.size());
  VertexWriter writer(mesh, colors, result);
  for (const Run& run : runs) {
    check_stop(limits);
    const std::span<std::uint32_t> mine = std::span(order).subspan(run.first, run.count);
    put_large_first(mesh, mine);
    Tile tile = make_tile(mesh, run, mine);
    writer.write(tile, mine);
    if (options.stand_in_of > 0 && run.count >= kLeastOfStandIn) {
      writer.write_stand_in(tile, stand_in(mesh, mine, tile.bounds,
                                           std::max<std::size_t>(run.count / options.stand_in_of,
                                                                 kLeastOfStandIn / 4)));
    }
    result.tiles.push_back(tile);
  }
  writer.finish();
  return result;
}

}  // namespace soms::view
