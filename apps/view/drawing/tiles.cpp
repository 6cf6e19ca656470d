#include "apps/view/drawing/tiles.h"

#include "soms/base/parallel.h"

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
/// The coarsest copy has one triangle for so many, and these at most: 128 tiles have 20,000.
constexpr std::size_t kLeastOf = 48;
constexpr std::size_t kMostOfLeast = 160;

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

/// Coarse copies of a tile.
struct Copies {
  std::vector<StandInTriangle> stand_in;
  std::vector<StandInTriangle> least;
};

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

  /// The coarse copies of the tile that was written last; they are kept for `finish`.
  void write(Tile& tile, const Copies& copies) {
    tile.stand_in_first = static_cast<std::uint32_t>(stand_ins_.size() / 3);
    tile.stand_in_count = static_cast<std::uint32_t>(copies.stand_in.size());
    write_copy(tile, copies.stand_in);
    tile.least_first = static_cast<std::uint32_t>(stand_ins_.size() / 3);
    tile.least_count = static_cast<std::uint32_t>(copies.least.size());
    write_copy(tile, copies.least);
  }

  /// Puts the stand-ins behind all triangles.
  void finish() {
    const auto before = static_cast<std::uint32_t>(result_.indices.size() / 3);
    for (Tile& tile : result_.tiles) {
      tile.stand_in_first += before;
      tile.least_first += before;
    }
    result_.indices.insert(result_.indices.end(), stand_ins_.begin(), stand_ins_.end());
  }

 private:
  void write_copy(const Tile& tile, std::span<const StandInTriangle> triangles) {
    for (const StandInTriangle& triangle : triangles) {
      const Color color = colors_.empty() ? Color{} : colors_[triangle.of];
      for (const Vec3& corner : {triangle.corners.a, triangle.corners.b, triangle.corners.c}) {
        stand_ins_.push_back(static_cast<std::uint32_t>(result_.vertices.size()));
        result_.vertices.push_back(vertex(corner, color, tile));
      }
    }
  }

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

Copies copies_of(const Mesh& mesh, std::span<const TriangleId> triangles, const Box& bounds,
                 const TileOptions& options) {
  if (options.stand_in_of == 0 || triangles.size() < kLeastOfStandIn) {
    return {};
  }
  const StandInMaker maker(mesh, triangles, bounds);
  Copies copies{
      maker.at_most(std::max(triangles.size() / options.stand_in_of, kLeastOfStandIn / 4)), {}};
  const std::size_t few = std::min(triangles.size() / kLeastOf, kMostOfLeast);
  copies.least =
      few < kLeastOfStandIn / 4 ? one_box(triangles.front(), bounds) : maker.at_most(few);
  if (copies.least.size() >= copies.stand_in.size()) {
    copies.least.clear();
  }
  return copies;
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
  const auto part = [&](std::size_t i) {
    return std::span(order).subspan(runs[i].first, runs[i].count);
  };
  result.tiles.resize(runs.size());
  std::vector<Copies> copies(runs.size());
  for_each_chunk(runs.size(), 1, limits, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      put_large_first(mesh, part(i));
      result.tiles[i] = make_tile(mesh, runs[i], part(i));
      copies[i] = copies_of(mesh, part(i), result.tiles[i].bounds, options);
    }
  });
  result.vertices.reserve(mesh.vertices.size());
  result.indices.reserve(3 * order.size());
  VertexWriter writer(mesh, colors, result);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    check_stop(limits);
    writer.write(result.tiles[i], part(i));
    writer.write(result.tiles[i], copies[i]);
  }
  writer.finish();
  return result;
}

}  // namespace soms::view
