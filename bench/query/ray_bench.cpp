// Rays at a knot and a city, from in and around their boxes: the first hit one by one and in
// batches, any hit, and all hits.
#include "soms/base/random.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/query/ray.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace soms {
namespace {

/// A model and 20,000 rays, made once for each size.
struct Range {
  explicit Range(Mesh mesh) : body(std::move(mesh)) {
    Rng rng(1);
    for (int i = 0; i < 20000; ++i) {
      const Vec3 from = place(rng, 0.5);
      rays.push_back({from, place(rng, 0) - from});
    }
  }

  /// A point of the box, or up to `rim` of its sides off it.
  [[nodiscard]] Vec3 place(Rng& rng, double rim) const {
    const Box& box = body.shape.bounds();
    Vec3 point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double more = box.extent()[axis] * rim;
      point[axis] = rng.uniform(box.lower[axis] - more, box.upper[axis] + more);
    }
    return point;
  }

  Body body;
  std::vector<Ray> rays;
};

const Range& range(const benchmark::State& state, bool city) {
  static std::map<std::pair<bool, std::int64_t>, Range> ranges;
  const auto triangles = static_cast<std::uint64_t>(state.range(0));
  const std::pair key(city, state.range(0));
  const auto found = ranges.find(key);
  return found != ranges.end()
             ? found->second
             : ranges
                   .emplace(key, Range(city ? generate_city({.triangles = triangles}).mesh
                                            : generate_knot(triangles)))
                   .first->second;
}

void count_rays(benchmark::State& state, const Cost& cost, std::size_t rays) {
  const auto n = static_cast<double>(state.iterations()) * static_cast<double>(rays);
  state.SetItemsProcessed(static_cast<std::int64_t>(n));
  state.counters["node_tests"] = static_cast<double>(cost.node_tests) / n;
  state.counters["triangle_tests"] = static_cast<double>(cost.triangle_tests) / n;
  state.counters["exact_tests"] = static_cast<double>(cost.exact_tests) / n;
}

void closest_hit_single(benchmark::State& state, bool city) {
  const Range& r = range(state, city);
  Cost cost;
  for ([[maybe_unused]] auto _ : state) {
    for (const Ray& ray : r.rays) {
      cost += closest_hit(r.body, ray).cost;
    }
  }
  count_rays(state, cost, r.rays.size());
}

void closest_hit_batch(benchmark::State& state, bool city) {
  const Range& r = range(state, city);
  Cost cost;
  for ([[maybe_unused]] auto _ : state) {
    cost += closest_hit(r.body, r.rays).cost;
  }
  count_rays(state, cost, r.rays.size());
}

void any_hit_batch(benchmark::State& state, bool city) {
  const Range& r = range(state, city);
  Cost cost;
  for ([[maybe_unused]] auto _ : state) {
    cost += any_hit(r.body, r.rays).cost;
  }
  count_rays(state, cost, r.rays.size());
}

void all_hits_batch(benchmark::State& state, bool city) {
  const Range& r = range(state, city);
  Cost cost;
  std::size_t crossings = 0;
  for ([[maybe_unused]] auto _ : state) {
    const AllHits hits = all_hits(r.body, r.rays);
    crossings = hits.lower.size();
    cost += hits.cost;
  }
  count_rays(state, cost, r.rays.size());
  state.counters["crossings"] = static_cast<double>(crossings) / static_cast<double>(r.rays.size());
}

BENCHMARK_CAPTURE(closest_hit_single, knot, false)->Arg(1000)->Arg(10000)->Arg(100000);
BENCHMARK_CAPTURE(closest_hit_single, city, true)->Arg(100000);
BENCHMARK_CAPTURE(closest_hit_batch, knot, false)->Arg(1000)->Arg(10000)->Arg(100000);
BENCHMARK_CAPTURE(closest_hit_batch, city, true)->Arg(100000);
BENCHMARK_CAPTURE(any_hit_batch, knot, false)->Arg(1000)->Arg(10000)->Arg(100000);
BENCHMARK_CAPTURE(all_hits_batch, knot, false)->Arg(1000)->Arg(10000)->Arg(100000);

}  // namespace
}  // namespace soms
