// Two random trees by any rule, in either layout, as built or refitted, at random poses: every way
// to ask for their overlap against brute force.
#include "soms/query/overlap.h"
#include "soms/query/reference/overlap.h"
#include "soms/thesis/overlap.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/check.h"
#include "soms/tree/refit.h"
#include "soms/tree/rule/rules.h"
#include "soms/tree/shape.h"

#include "tests/fuzz/bytes.h"
#include "tests/fuzz/poses.h"
#include "tests/fuzz/require.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace soms {
namespace {

using fuzz::Bytes;
using fuzz::require;

/// How the coordinates of a mesh are drawn.
struct Grid {
  explicit Grid(Bytes& bytes)
      : coarse(bytes.below(2) == 0),
        unit(std::ldexp(1.0, static_cast<int>(bytes.below(80)) - 40)),
        shift(bytes.below(4) == 0 ? 1e6 * bytes.fraction() : 0) {}

  /// A lattice of nine points a side makes triangles touch; fractions make them miss barely.
  double coordinate(Bytes& bytes) const {
    return shift + unit * (coarse ? bytes.below(9) : 8 * bytes.fraction());
  }

  bool coarse;
  double unit;
  double shift;
};

/// Some meshes are small beside the other, and some lie flat, as cities do.
Mesh mesh_of(Bytes& bytes, const Grid& grid) {
  constexpr std::uint32_t kMost = 40;
  const double size = bytes.below(2) == 0 ? 1 : std::ldexp(1.0, -static_cast<int>(bytes.below(12)));
  const double height = bytes.below(3) == 0 ? 0.125 * size : size;
  Mesh mesh;
  const std::uint32_t triangles = bytes.below(kMost);
  for (std::uint32_t i = 0; i < triangles; ++i) {
    std::array<std::uint32_t, 3> corners = {};
    for (std::uint32_t& corner : corners) {
      const std::uint32_t choice = bytes.byte();
      if (choice < 128 || mesh.vertices.empty()) {
        const double x = grid.coordinate(bytes);
        const double y = grid.coordinate(bytes);
        mesh.vertices.push_back({size * x, size * y, height * grid.coordinate(bytes)});
        corner = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
      } else {
        corner = choice % static_cast<std::uint32_t>(mesh.vertices.size());
      }
    }
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

ShapeOptions options_of(Bytes& bytes) {
  ShapeOptions options;
  const auto table = rules();
  options.build.rule = table[bytes.below(static_cast<std::uint32_t>(table.size()))].rule;
  options.build.per_leaf = static_cast<int>(1 + bytes.below(16));
  options.build.level = static_cast<int>(bytes.below(3) == 0 ? 1 + bytes.below(7) : 0);
  options.layout = bytes.below(3) == 0 ? Layout::compact : Layout::wide;
  options.keep_tree = true;
  return options;
}

/// Threads, modes, the named traversals and the other order of the bodies.
void check_one(const Body& a, const Body& b, const std::vector<TrianglePair>& truth, Bytes& bytes) {
  const Overlap all = overlap(a, b);
  require(all.pairs == truth && all.any == !truth.empty(), "all pairs");
  const Overlap any = overlap(a, b, {.mode = OverlapMode::any});
  require(any.any == all.any, "any");
  require(!any.any || std::binary_search(truth.begin(), truth.end(), any.pairs.at(0)),
          "the pair of any");
  const Overlap first = overlap(a, b, {.mode = OverlapMode::first});
  require(first.any == all.any && (!first.any || first.pairs.at(0) == truth.front()), "first");
  require(overlap(a, b, {}, {.threads = 2}).pairs == truth, "two threads");
  std::vector<TrianglePair> swapped;
  for (const auto& [j, i] : overlap(b, a).pairs) {
    swapped.emplace_back(i, j);
  }
  std::sort(swapped.begin(), swapped.end());
  require(swapped == truth, "bodies swapped");
  const auto table = traversals();
  TraversalOptions settings;
  settings.traversal = table[bytes.below(static_cast<std::uint32_t>(table.size()))].traversal;
  settings.update = bytes.below(2) == 0 ? BoxUpdate::refit : BoxUpdate::rebox;
  settings = without_idle(settings);
  require(thesis::overlap(a, b, settings).answer.pairs == truth, "a named traversal");
}

/// Answers of a batch equal those of single queries, costs too.
void check_batch(const Shape& mover, const std::vector<Pose>& poses, const Body& fixed) {
  for (const OverlapMode mode : {OverlapMode::all, OverlapMode::any}) {
    const OverlapBatch batch = overlap(mover, poses, fixed, {.mode = mode});
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const Overlap single = overlap(Body(mover, poses[k]), fixed, {.mode = mode});
      const auto pairs = batch.pairs_of(k);
      require(std::equal(pairs.begin(), pairs.end(), single.pairs.begin(), single.pairs.end()),
              "pairs of a batch");
      require(batch.costs[k].node_tests == single.cost.node_tests, "cost of a batch");
    }
  }
}

/// The shape of a mesh. One in two was built for vertices at other places, and then refitted.
Shape shape_of(const Mesh& mesh, const Grid& grid, Bytes& bytes) {
  const ShapeOptions options = options_of(bytes);
  if (bytes.below(2) == 0) {
    return Shape(mesh, options);
  }
  Mesh before = mesh;
  for (Vec3& v : before.vertices) {
    (bytes.below(2) == 0 ? v.x : v.z) = grid.coordinate(bytes);
  }
  Shape refitted = refit(Shape(std::move(before), options), mesh.vertices);
  require(refitted.mesh() == mesh, "the mesh of a refitted shape");
  return refitted;
}

void check_input(Bytes& bytes) {
  const Grid grid(bytes);
  const Mesh first = mesh_of(bytes, grid);
  const Mesh second = mesh_of(bytes, grid);
  const Shape a = shape_of(first, grid, bytes);
  const Shape b = shape_of(second, grid, bytes);
  for (const Shape* shape : {&a, &b}) {
    require(find_fault(*shape->tree(), shape->mesh()).empty(), "a whole tree");
  }
  const Body fixed(b, fuzz::pose_of(bytes, grid.unit));
  std::vector<Pose> poses;
  for (std::uint32_t k = 0, count = 1 + bytes.below(6); k < count; ++k) {
    poses.push_back(fuzz::pose_of(bytes, grid.unit));
  }
  for (const Pose& pose : poses) {
    const Overlap truth = reference::overlap(first, pose, second, fixed.pose);
    check_one(Body(a, pose), fixed, truth.pairs, bytes);
  }
  check_batch(a, poses, fixed);
}

}  // namespace
}  // namespace soms

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  soms::fuzz::Bytes bytes({data, size});
  soms::check_input(bytes);
  return 0;
}
