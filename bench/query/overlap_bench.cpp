// Our own parts: building, and overlap of a car with a city, one by one and in batches.
#include "soms/generate/routes.h"
#include "soms/generate/shapes.h"
#include "soms/query/overlap.h"

#include <benchmark/benchmark.h>

#include <map>

namespace soms {
namespace {

/// A city with a car on its streets; made once for each size.
struct Place {
  explicit Place(std::uint64_t triangles) : city(generate_city({.triangles = triangles})) {
    world = Body(city.mesh);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const Route route = street_route(city, seed, 12, 0.12);
      for (int i = 0; i < 20; ++i) {
        poses.push_back(route.at(0.5 * i));
      }
    }
  }

  City city;
  Body world;
  Shape car{generate_mover(MoverKind::car)};
  std::vector<Pose> poses;
};

const Place& place(const benchmark::State& state) {
  static std::map<std::int64_t, Place> places;
  const auto triangles = state.range(0);
  return places.try_emplace(triangles, static_cast<std::uint64_t>(triangles)).first->second;
}

void report(benchmark::State& state, const Cost& cost, std::int64_t queries) {
  state.SetItemsProcessed(queries);
  const auto n = static_cast<double>(queries);
  state.counters["node_tests"] = static_cast<double>(cost.node_tests) / n;
  state.counters["triangle_tests"] = static_cast<double>(cost.triangle_tests) / n;
  state.counters["exact_tests"] = static_cast<double>(cost.exact_tests) / n;
}

void single(benchmark::State& state, OverlapMode mode) {
  const Place& p = place(state);
  Body car(p.car);
  Cost cost;
  std::int64_t queries = 0;
  for ([[maybe_unused]] auto _ : state) {
    for (const Pose& pose : p.poses) {
      car.pose = pose;
      const Overlap answer = overlap(car, p.world, {.mode = mode});
      cost += answer.cost;
      benchmark::DoNotOptimize(answer.any);
    }
    queries += static_cast<std::int64_t>(p.poses.size());
  }
  report(state, cost, queries);
}

void overlap_any(benchmark::State& state) {
  single(state, OverlapMode::any);
}

void overlap_all(benchmark::State& state) {
  single(state, OverlapMode::all);
}

void overlap_batch(benchmark::State& state) {
  const Place& p = place(state);
  Cost cost;
  std::int64_t queries = 0;
  for ([[maybe_unused]] auto _ : state) {
    const OverlapBatch batch = overlap(p.car, p.poses, p.world, {.mode = OverlapMode::any});
    cost += batch.cost;
    benchmark::DoNotOptimize(batch.any.data());
    queries += static_cast<std::int64_t>(p.poses.size());
  }
  report(state, cost, queries);
}

void build_shape(benchmark::State& state) {
  const Place& p = place(state);
  const auto mesh = p.world.shape.shared_mesh();
  for ([[maybe_unused]] auto _ : state) {
    const Shape shape(mesh);
    benchmark::DoNotOptimize(&shape.layout());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void generate(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    const City city = generate_city({.triangles = static_cast<std::uint64_t>(state.range(0))});
    benchmark::DoNotOptimize(city.mesh.triangles.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK(overlap_any)->ArgName("triangles")->Arg(5'672)->Arg(100'000)->Arg(1'000'000);
BENCHMARK(overlap_all)->ArgName("triangles")->Arg(5'672)->Arg(100'000)->Arg(1'000'000);
BENCHMARK(overlap_batch)->ArgName("triangles")->Arg(5'672)->Arg(100'000)->Arg(1'000'000);
BENCHMARK(build_shape)
    ->ArgName("triangles")
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(generate)->ArgName("triangles")->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace soms
