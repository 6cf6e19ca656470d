// Nearest points: of a knot and of a city to points in and around their boxes, one by one, in
// batches, and lists of eight triangles.
#include "soms/base/random.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/query/closest.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace soms {
namespace {

/// A model and 20,000 points, made once for each size.
struct Cloud {
  explicit Cloud(Mesh mesh) : body(std::move(mesh)) {
    const Box& box = body.shape.bounds();
    const Vec3 rim = box.extent() * 0.1;
    Rng rng(1);
    for (int i = 0; i < 20000; ++i) {
      Vec3 point;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        point[axis] = rng.uniform(box.lower[axis] - rim[axis], box.upper[axis] + rim[axis]);
      }
      points.push_back(point);
    }
  }

  Body body;
  std::vector<Vec3> points;
};

const Cloud& cloud(const benchmark::State& state, bool city) {
  static std::map<std::pair<bool, std::int64_t>, Cloud> clouds;
  const auto triangles = static_cast<std::uint64_t>(state.range(0));
  const std::pair key(city, state.range(0));
  const auto found = clouds.find(key);
  return found != clouds.end()
             ? found->second
             : clouds
                   .emplace(key, Cloud(city ? generate_city({.triangles = triangles}).mesh
                                            : generate_knot(triangles)))
                   .first->second;
}

void count_points(benchmark::State& state, const Cost& cost, std::size_t points) {
  const auto n = static_cast<double>(state.iterations()) * static_cast<double>(points);
  state.SetItemsProcessed(static_cast<std::int64_t>(n));
  state.counters["node_tests"] = static_cast<double>(cost.node_tests) / n;
  state.counters["triangle_tests"] = static_cast<double>(cost.triangle_tests) / n;
  state.counters["exact_tests"] = static_cast<double>(cost.exact_tests) / n;
}

void closest_single(benchmark::State& state, bool city) {
  const Cloud& c = cloud(state, city);
  Cost cost;
  for ([[maybe_unused]] auto _ : state) {
    for (const Vec3& point : c.points) {
      const Closest answer = closest(c.body, point);
      cost += answer.cost;
      benchmark::DoNotOptimize(answer.distance);
    }
  }
  count_points(state, cost, c.points.size());
}

void closest_batch(benchmark::State& state, bool city) {
  const Cloud& c = cloud(state, city);
  Cost cost;
  for ([[maybe_unused]] auto _ : state) {
    cost += closest(c.body, c.points).cost;
  }
  count_points(state, cost, c.points.size());
}

void nearest_eight(benchmark::State& state, bool city) {
  const Cloud& c = cloud(state, city);
  Cost cost;
  for ([[maybe_unused]] auto _ : state) {
    cost += nearest_triangles(c.body, c.points, 8).cost;
  }
  count_points(state, cost, c.points.size());
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("triangles")
      ->Arg(10'000)
      ->Arg(100'000)
      ->Arg(1'000'000)
      ->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(closest_single, knot, false)->Apply(sizes);
BENCHMARK_CAPTURE(closest_single, city, true)->Apply(sizes);
BENCHMARK_CAPTURE(closest_batch, knot, false)->Apply(sizes);
BENCHMARK_CAPTURE(closest_batch, city, true)->Apply(sizes);
BENCHMARK_CAPTURE(nearest_eight, knot, false)->Apply(sizes);
BENCHMARK_CAPTURE(nearest_eight, city, true)->Apply(sizes);

}  // namespace
}  // namespace soms
