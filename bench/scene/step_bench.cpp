// Steps of a scene: 1,000 cars on the streets of a city of a million triangles, 60 frames a second.
// With what the steps before left against from nothing, and plain against swept, in turns, by
// processor time; then two threads against one by the clock, beside a loop that needs no memory.
#include "soms/base/hash.h"
#include "soms/base/parallel.h"
#include "soms/generate/city.h"
#include "soms/generate/routes.h"
#include "soms/generate/shapes.h"
#include "soms/scene/scene.h"

#include "bench/measure.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

namespace soms::bench {
namespace {

constexpr std::uint32_t kCars = 1000;
constexpr int kFrames = 240;

double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Two scenes of the same bodies, and where the cars drive.
struct Traffic {
  Scene kept;
  Scene rebuilt;
  std::vector<Route> routes;

  Traffic() {
    City city = generate_city(CityOptions{});
    const Shape car(generate_mover(MoverKind::car));
    for (std::uint32_t k = 0; k < kCars; ++k) {
      routes.push_back(street_route(city, k + 1, 8 + k % 7, 0.1));
      routes.back().base = 2.6;
      routes.back().measure();
    }
    const Body fixed{Shape(std::move(city.mesh))};
    for (Scene* const scene : {&kept, &rebuilt}) {
      scene->add_environment(fixed);
      for (const Route& route : routes) {
        scene->add_mover(Body(car, route.at(0)));
      }
    }
  }

  void drive(Scene& scene, int frame) const {
    for (MoverId id = 0; id < kCars; ++id) {
      scene.set_pose(id, routes[id].at(frame / 60.0));
    }
  }
};

/// Two kinds of steps and what they are called, in turns: both scenes take the same way.
void compare(Traffic& traffic, const char* name,
             const std::array<std::pair<StepOptions, const char*>, 2>& kinds) {
  std::array<std::vector<double>, 2> seconds;
  std::array<Fnv1a, 2> hash;
  for (std::size_t frame = 0; frame < kFrames; ++frame) {
    traffic.drive(traffic.kept, static_cast<int>(frame));
    traffic.drive(traffic.rebuilt, static_cast<int>(frame));
    for (std::size_t turn = 0; turn < 2; ++turn) {
      const std::size_t k = (turn + frame) % 2;
      const double begin = processor_seconds();
      const auto report = (k == 0 ? traffic.kept : traffic.rebuilt).step(kinds[k].first);
      seconds[k].push_back(processor_seconds() - begin);
      hash[k].add(report.hash());
    }
  }
  const double a = 1e3 * median(seconds[0]);
  const double b = 1e3 * median(seconds[1]);
  std::printf("%-24s %8.3f ms %s %8.3f ms %s: ratio %.2f, answers %s\n", name, a, kinds[0].second,
              b, kinds[1].second, b / a,
              hash[0].value() == hash[1].value() ? "the same" : "DIFFER");
}

/// Seconds of `body` on one thread and on two, the better of some runs in turn.
template <typename Body>
void compare_threads(const char* name, const Body& body) {
  double one = 1e9;
  double two = 1e9;
  for (int run = 0; run < 5; ++run) {
    double begin = clock_seconds();
    body(Limits{.threads = 1});
    one = std::min(one, clock_seconds() - begin);
    begin = clock_seconds();
    body(Limits{.threads = 2});
    two = std::min(two, clock_seconds() - begin);
  }
  std::printf("%-24s %8.1f ms one thread %8.1f ms two threads: ratio %.2f\n", name, 1e3 * one,
              1e3 * two, one / two);
}

void plain_loop(const Limits& limits) {
  for_each_chunk(64, 1, limits, [](std::size_t begin, std::size_t) {
    volatile double sink = 0;
    double sum = static_cast<double>(begin);
    for (int k = 0; k < 200000; ++k) {
      sum = sum * 0.999 + 1;
    }
    sink = sum;
    static_cast<void>(sink);
  });
}

}  // namespace
}  // namespace soms::bench

int main() {
  using namespace soms;
  const auto traffic = std::make_unique<bench::Traffic>();
  bench::compare(*traffic, "all pairs", {{{{}, "kept"}, {{.coherent = false}, "from nothing"}}});
  constexpr OverlapMode kAny = OverlapMode::any;
  bench::compare(*traffic, "any pair",
                 {{{{.mode = kAny}, "kept"}, {{.mode = kAny, .coherent = false}, "from nothing"}}});
  bench::compare(*traffic, "ways", {{{{}, "plain"}, {{.swept = true}, "swept"}}});
  bench::compare_threads("plain loop", bench::plain_loop);
  bench::compare_threads("60 steps", [&](const Limits& limits) {
    for (int frame = 0; frame < 60; ++frame) {
      traffic->drive(traffic->kept, frame);
      static_cast<void>(traffic->kept.step({}, limits));
    }
  });
  return 0;
}
