#include "thesis/claims/comparison.h"

#include "soms/base/random.h"
#include "soms/query/overlap.h"
#include "soms/tree/build.h"
#include "soms/tree/rule/rules.h"

#include "thesis/trips/contenders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr std::array kCubeShares{0.001, 0.01, 0.1};

Box cube(const Vec3& center, const Vec3& size) {
  const Vec3 half = 0.5 * size;
  return {center - half, center + half};
}

Vec3 draw_within(const Box& box, Rng& rng) {
  const double x = rng.uniform(box.lower.x, box.upper.x);
  const double y = rng.uniform(box.lower.y, box.upper.y);
  const double z = rng.uniform(box.lower.z, box.upper.z);
  return {x, y, z};
}

Vec3 draw_triangle_center(const Mesh& mesh, Rng& rng) {
  const Triangle t = mesh.triangle(static_cast<TriangleId>(rng.below(mesh.triangles.size())));
  return midpoint(t, Midpoint::centroid);
}

Workload::Cubes draw_cubes(const Mesh& mesh, const Box& whole, double share, int count, Rng& rng) {
  const Vec3 extent = whole.extent();
  const double side = share * std::max({extent.x, extent.y, extent.z});
  Workload::Cubes cubes{.share = share, .size = {side, side, side}};
  const Box centers = cube(whole.center(), extent + cubes.size);
  for (int i = 0; i < count; ++i) {
    cubes.anywhere.push_back(cube(draw_within(centers, rng), cubes.size));
  }
  for (int i = 0; i < count; ++i) {
    const Box about = cube(draw_triangle_center(mesh, rng), 2 * cubes.size);
    cubes.near.push_back(cube(draw_within(about, rng), cubes.size));
  }
  return cubes;
}

/// A turn about z by an angle drawn from a half turn, as a rational point of the circle: the same
/// bits on every machine.
Pose draw_pose(const Mesh& mesh, const Box& mover, Rng& rng) {
  const double t = rng.uniform(-1, 1);
  const double w = (1 - t * t) / (1 + t * t);
  const double z = 2 * t / (1 + t * t);
  const Box about = cube(draw_triangle_center(mesh, rng), mover.extent());
  const Vec3 to = draw_within(about, rng);
  return Pose::from_quaternion(w, 0, 0, z, to - mover.center());
}

ExpectedVisits mean_visits(const Tree& tree, std::span<const Box> queries) {
  Visits sum;
  for (const Box& query : queries) {
    const Visits visits = count_visits(tree, query);
    sum.nodes += visits.nodes;
    sum.leaves += visits.leaves;
    sum.triangles += visits.triangles;
  }
  const auto n = static_cast<double>(queries.size());
  return {static_cast<double>(sum.nodes) / n, static_cast<double>(sum.leaves) / n,
          static_cast<double>(sum.triangles) / n};
}

/// What can be counted. The tree is dropped afterwards, the shape is kept for the timing.
Measured measure(const Shape& shape, const ComparedBuild& build, const Workload& workload,
                 const Limits& limits) {
  const Tree tree = soms::build(shape.mesh(), build.build, limits);
  Measured m{
      .build = build,
      .counts = statistics(tree, build.build),
      .sah_cost = sah_cost(tree),
      .tree_bytes = tree.nodes.size() * sizeof(Node) + tree.primitives.size() * sizeof(TriangleId),
      .layout_bytes = shape.layout_memory(),
      .mesh_bytes = shape.memory() - shape.layout_memory()};
  for (const Workload::Cubes& cubes : workload.cubes) {
    m.sides.push_back({cubes.share, expected_visits(tree, cubes.size),
                       mean_visits(tree, cubes.anywhere), mean_visits(tree, cubes.near)});
    check_stop(limits);
  }
  return m;
}

OverlapBatch ask_all(const Workload& workload, const Shape& shape, OverlapMode mode,
                     const Limits& limits) {
  return overlap(workload.mover, workload.poses, Body(shape), {.mode = mode}, limits);
}

void time_compared(std::vector<Measured>& measured, const std::shared_ptr<const Mesh>& mesh,
                   int repetitions, const Limits& limits) {
  std::vector<std::function<void()>> works;
  for (const Measured& m : measured) {
    works.emplace_back(
        [&mesh, &m, &limits] { static_cast<void>(build(*mesh, m.build.build, limits)); });
    works.emplace_back([&mesh, &m, &limits] {
      static_cast<void>(Shape(mesh, ShapeOptions{.build = m.build.build}, limits));
    });
  }
  const std::vector<Timing> timings = time_in_turn(repetitions, limits, works, 1);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    measured[i].build_ms = timings[2 * i];
    measured[i].shape_ms = timings[2 * i + 1];
  }
}

void time_queries(std::vector<Measured>& measured, const std::vector<Shape>& shapes,
                  const Workload& workload, int repetitions, const Limits& limits) {
  for (const OverlapMode mode : {OverlapMode::any, OverlapMode::all}) {
    std::vector<std::function<void()>> works;
    works.reserve(shapes.size());
    for (const Shape& shape : shapes) {
      works.emplace_back([&shape, &workload, mode, &limits] {
        static_cast<void>(ask_all(workload, shape, mode, limits));
      });
    }
    const std::vector<Timing> timings = time_in_turn(repetitions, limits, works, 1);
    for (std::size_t i = 0; i < measured.size(); ++i) {
      (mode == OverlapMode::any ? measured[i].any_ms : measured[i].all_ms) = timings[i];
    }
  }
}

bool is_of_thesis_and_dear(const ComparedBuild& build) {
  return build.options == "one a leaf" ||
         (build.options == "thesis" && build.rule != "spatial_median" && build.rule != "soms") ||
         build.rule == "object_mean";
}

}  // namespace

std::vector<ComparedBuild> compared_builds(int level, bool few) {
  std::vector<ComparedBuild> builds;
  for (const Contender& contender : thesis_rules(level)) {
    builds.push_back({contender.name, "thesis", contender.options});
  }
  builds.push_back({"sah", "one a leaf", {.rule = Rule::sah, .level = level, .per_leaf = 1}});
  for (const RuleEntry& rule : rules()) {
    builds.push_back({std::string(rule.name), "product", {.rule = rule.rule}});
  }
  if (few) {
    std::erase_if(builds, is_of_thesis_and_dear);
  }
  return builds;
}

Workload make_workload(const Mesh& mesh, const Mesh& mover, std::string mover_name, int cubes,
                       int poses) {
  const Box whole = bounds(mesh);
  Rng rng(mesh.triangles.size());
  Workload workload;
  for (const double share : kCubeShares) {
    // Large cubes look at a large part of the tree each, so fewer will do.
    const int count = share < 0.1 ? cubes : std::max(1, cubes / 5);
    workload.cubes.push_back(draw_cubes(mesh, whole, share, count, rng));
  }
  workload.mover = Shape(mover);
  workload.mover_name = std::move(mover_name);
  for (int i = 0; i < poses; ++i) {
    workload.poses.push_back(draw_pose(mesh, workload.mover.bounds(), rng));
  }
  return workload;
}

Compared compare(const Model& model, std::span<const ComparedBuild> builds,
                 const Workload& workload, int repetitions, const Limits& limits) {
  const Limits alone = limits.alone();
  const Vec3 extent = bounds(*model.mesh).extent();
  Compared compared{.model = model.name,
                    .triangles = model.mesh->triangles.size(),
                    .longest_side = std::max({extent.x, extent.y, extent.z}),
                    .spread = spread_of_sizes(*model.mesh),
                    .mover = workload.mover_name,
                    .queries = workload.poses.size()};
  std::vector<Shape> shapes;
  for (const ComparedBuild& build : builds) {
    shapes.emplace_back(model.mesh, ShapeOptions{.build = build.build}, alone);
    Measured& m = compared.builds.emplace_back(measure(shapes.back(), build, workload, alone));
    const OverlapBatch any = ask_all(workload, shapes.back(), OverlapMode::any, alone);
    const OverlapBatch all = ask_all(workload, shapes.back(), OverlapMode::all, alone);
    m.any = any.cost;
    m.all = all.cost;
    m.hits = static_cast<std::uint64_t>(std::count(all.any.begin(), all.any.end(), 1));
    m.pairs = all.pairs.size();
  }
  time_compared(compared.builds, model.mesh, repetitions, alone);
  time_queries(compared.builds, shapes, workload, repetitions, alone);
  return compared;
}

double spread_of_sizes(const Mesh& mesh) {
  std::vector<double> squares;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    double longest = 0;
    for (const Vec3& e : {t.b - t.a, t.c - t.b, t.a - t.c}) {
      longest = std::max(longest, e.x * e.x + e.y * e.y + e.z * e.z);
    }
    squares.push_back(longest);
  }
  if (squares.empty()) {
    return 0;
  }
  std::sort(squares.begin(), squares.end());
  const double low = squares[(squares.size() - 1) / 20];
  const double high = squares[(squares.size() - 1) * 19 / 20];
  return low > 0 ? 0.5 * std::log10(high / low) : 0;
}

double looks(const ExpectedVisits& visits) {
  return visits.nodes + visits.triangles;
}

}  // namespace soms::reproduce
