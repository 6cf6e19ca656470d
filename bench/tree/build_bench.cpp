// Building beside Embree: how long every rule takes from mesh to Shape, what its tree costs a
// query, what it weighs, and how well two threads build. One process; libraries in a turning
// order.
#include "soms/query/overlap.h"
#include "soms/tree/layout/detail/wide_tree.h"
#include "soms/tree/refit.h"
#include "soms/tree/rule/rules.h"

#include "bench/measure.h"
#include "bench/peers/core/machine.h"
#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#if SOMS_BENCH_EMBREE
#include <embree3/rtcore.h>
#endif

namespace soms::bench {
namespace {

/// A mesh of a million triangles, a mover, and poses at which both are queried.
struct Place {
  std::string name;
  std::shared_ptr<const Mesh> mesh;
  FloatMesh floats;  ///< the same for Embree
  std::shared_ptr<const Mesh> mover;
  bool own_twin = false;  ///< the mover is the mesh itself, built the same way
  std::vector<PoseSet> sets;
};

std::shared_ptr<const Mesh> wide_mesh(const FloatMesh& from) {
  return std::make_shared<const Mesh>(widened(from));
}

Pose shifted(Pose pose, const Vec3& t) {
  pose.m[3] = t.x;
  pose.m[7] = t.y;
  pose.m[11] = t.z;
  return pose;
}

/// Turned at random, slid in until both touch, and out again by 0.001 of their reach.
Pose near_miss(Body& knot, const Body& twin, Rng& rng) {
  const Pose turned = random_rotation(rng, {});
  const Vec3 direction = random_direction(rng);
  const auto touches = [&](double s) {
    knot.pose = shifted(turned, s * direction);
    return overlap(knot, twin, {.mode = OverlapMode::any}).any;
  };
  double apart = 2.5;
  double touching = apart;
  while (touching > -2.5 && !touches(touching)) {
    apart = touching;
    touching -= 0.05;
  }
  while (apart - touching > 1e-5) {
    const double middle = 0.5 * (apart + touching);
    (touches(middle) ? touching : apart) = middle;
  }
  return shifted(turned, (apart + 0.001) * direction);
}

Place knot_place() {
  Place place{"knot 1M", {}, torus_knot(2500, 200), {}, true, {{"random", {}}, {"near", {}}}};
  place.mesh = wide_mesh(place.floats);
  place.mover = place.mesh;
  Rng rng(11);
  for (std::size_t i = 0; i < kPoses; ++i) {
    const Pose turned = random_rotation(rng, {});
    place.sets[0].poses.push_back(shifted(turned, rng.uniform(1.0, 1.9) * random_direction(rng)));
  }
  constexpr std::size_t kNear = 200;
  const Body twin{Shape(place.mesh)};
  Body knot = twin;
  for (std::size_t i = 0; i < kNear; ++i) {
    place.sets[1].poses.push_back(near_miss(knot, twin, rng));
  }
  return place;
}

Place city_place() {
  Scene scene = city_car_scene(1'000'000, 1);
  return {"city 1M", wide_mesh(scene.fixed), scene.fixed, wide_mesh(scene.mover),
          false,     std::move(scene.sets)};
}

/// Something that turns the mesh of a place into a tree; what it made is dropped at once.
struct BuilderUnderTest {
  std::string name;
  std::function<void(const Place&)> build;
};

#if SOMS_BENCH_EMBREE
void add_embree(std::vector<BuilderUnderTest>& builders) {
  const std::shared_ptr<RTCDeviceTy> device(rtcNewDevice("threads=1,set_affinity=0"),
                                            [](RTCDevice d) { rtcReleaseDevice(d); });
  const auto add = [&](const char* name, RTCBuildQuality quality) {
    builders.push_back(
        {name, [device, quality](const Place& place) {
           const RTCScene scene = rtcNewScene(device.get());
           rtcSetSceneBuildQuality(scene, quality);
           const RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
           rtcSetGeometryBuildQuality(geometry, quality);
           const auto& v = place.floats.vertices;
           const auto& t = place.floats.triangles;
           rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                      v.data(), 0, sizeof v[0], v.size());
           rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                      t.data(), 0, sizeof t[0], t.size());
           rtcCommitGeometry(geometry);
           rtcAttachGeometry(scene, geometry);
           rtcReleaseGeometry(geometry);
           rtcCommitScene(scene);
           rtcReleaseScene(scene);
         }});
  };
  add("embree-low", RTC_BUILD_QUALITY_LOW);
  add("embree-medium", RTC_BUILD_QUALITY_MEDIUM);
}
#endif

std::vector<BuilderUnderTest> builders_of(const std::vector<const RuleEntry*>& chosen) {
  std::vector<BuilderUnderTest> builders;
  for (const RuleEntry* e : chosen) {
    ShapeOptions options;
    options.build.rule = e->rule;
    builders.push_back({std::string(e->kebab),
                        [options](const Place& place) { const Shape shape(place.mesh, options); }});
  }
#if SOMS_BENCH_EMBREE
  add_embree(builders);
#endif
  return builders;
}

/// Seconds of all passes: what other programs take is in the median, and hardly in the least.
struct Spread {
  double least;
  double median;
};

/// Passes in a turning order. A first pass warms all and is not counted.
std::vector<Spread> race_builds(const std::vector<BuilderUnderTest>& builders, const Place& place,
                                int passes) {
  std::vector<std::vector<double>> seconds(builders.size());
  for (int p = -1; p < passes; ++p) {
    for (std::size_t k = 0; k < builders.size(); ++k) {
      const std::size_t i = (k + static_cast<std::size_t>(p + 1)) % builders.size();
      const double start = processor_seconds();
      builders[i].build(place);
      if (p >= 0) {
        seconds[i].push_back(processor_seconds() - start);
      }
    }
  }
  std::vector<Spread> spreads;
  spreads.reserve(seconds.size());
  for (const std::vector<double>& s : seconds) {
    spreads.push_back({*std::min_element(s.begin(), s.end()), median(s)});
  }
  return spreads;
}

/// The trees of a rule that queries are queried of.
struct Kept {
  std::string name;
  ShapeOptions options;
};

std::vector<Kept> kept_of(const std::vector<const RuleEntry*>& chosen, bool compact) {
  std::vector<Kept> all;
  for (const RuleEntry* e : chosen) {
    ShapeOptions options;
    options.build.rule = e->rule;
    all.push_back({std::string(e->kebab), options});
    if (compact) {
      options.layout = Layout::compact;
      all.push_back({std::string(e->kebab) + ", compact", options});
    }
  }
  return all;
}

/// Asks every pose of a set of each tree, in turn.
void race_queries(const std::vector<Kept>& chosen, const Place& place, int passes) {
  struct Tree {
    Body mover;
    Body fixed;
  };

  std::vector<Tree> trees;
  for (const Kept& kept : chosen) {
    const Shape fixed(place.mesh, kept.options);
    const Shape mover = place.own_twin ? fixed : Shape(place.mover, kept.options);
    trees.push_back({Body(mover), Body(fixed)});
    const auto n = static_cast<double>(place.mesh->triangles.size());
    const WideTree& layout = fixed.layout();
    std::printf("%-16s %6.1f bytes a triangle in all, layout %6.1f; %5.2f triangles a block\n",
                kept.name.c_str(), static_cast<double>(fixed.memory()) / n,
                static_cast<double>(layout.memory()) / n,
                n / static_cast<double>(layout.expanded(*place.mesh).blocks().size()));
  }
  for (const PoseSet& set : place.sets) {
    std::vector<std::vector<double>> seconds(trees.size());
    std::vector<Cost> costs(trees.size());
    std::vector<std::size_t> hits(trees.size());
    for (int p = -1; p < passes; ++p) {
      for (std::size_t k = 0; k < trees.size(); ++k) {
        const std::size_t i = (k + static_cast<std::size_t>(p + 1)) % trees.size();
        const double start = processor_seconds();
        for (const Pose& pose : set.poses) {
          trees[i].mover.pose = pose;
          const Overlap answer =
              overlap(trees[i].mover, trees[i].fixed, {.mode = OverlapMode::any});
          if (p < 0) {
            costs[i] += answer.cost;
            hits[i] += answer.any ? 1 : 0;
          }
        }
        if (p >= 0) {
          seconds[i].push_back(processor_seconds() - start);
        }
      }
    }
    const auto n = static_cast<double>(set.poses.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
      std::printf("%-16s any %-9s %8.3f us  %9.1f node tests  %8.1f triangle tests  %zu hits\n",
                  chosen[i].name.c_str(), set.name.c_str(), 1e6 * median(seconds[i]) / n,
                  static_cast<double>(costs[i].node_tests) / n,
                  static_cast<double>(costs[i].triangle_tests) / n, hits[i]);
    }
  }
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A loop that needs nothing but the processor.
void spin() {
  volatile double start = 0.5;
  double x = start;
  for (int i = 0; i < 100'000'000; ++i) {
    x = x * 0.999999 + 1e-7;
  }
  start = x;
}

/// Wall time of one thread over that of two, in turn with a plain loop that shows what is there.
void race_threads(const std::vector<const RuleEntry*>& chosen, const Place& place, int passes) {
  std::vector<double> loop;
  std::vector<std::vector<double>> gains(chosen.size());
  for (int p = 0; p < passes; ++p) {
    double start = wall_seconds();
    spin();
    spin();
    const double one = wall_seconds() - start;
    start = wall_seconds();
    {
      const std::jthread other(spin);
      spin();
    }
    loop.push_back(one / (wall_seconds() - start));
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      ShapeOptions options;
      options.build.rule = chosen[i]->rule;
      std::array<double, 3> seconds = {};
      for (int threads = 1; threads <= 2; ++threads) {
        start = wall_seconds();
        const Shape shape(place.mesh, options, Limits{.threads = threads});
        seconds[static_cast<std::size_t>(threads)] = wall_seconds() - start;
      }
      gains[i].push_back(seconds[1] / seconds[2]);
    }
  }
  std::printf("two threads: a plain loop %.2f", median(loop));
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    std::printf(", %s %.2f", chosen[i]->kebab.data(), median(gains[i]));
  }
  std::printf(" times one\n");
}

/// The knot or city turned about the z axis by an angle that grows along x, so that all of it
/// bends.
std::shared_ptr<const Mesh> twisted(const Mesh& mesh, double turns) {
  Mesh moved = mesh;
  const double rate = turns * 2 * std::acos(-1.0) / bounds(mesh).extent().x;
  for (Vec3& v : moved.vertices) {
    const double s = std::sin(rate * v.x);
    const double c = std::cos(rate * v.x);
    v = {v.x, c * v.y - s * v.z, s * v.y + c * v.z};
  }
  return std::make_shared<const Mesh>(std::move(moved));
}

double seconds_of(const std::function<void()>& action, int passes) {
  std::vector<double> seconds;
  for (int p = -1; p < passes; ++p) {
    const double start = processor_seconds();
    action();
    if (p >= 0) {
      seconds.push_back(processor_seconds() - start);
    }
  }
  return median(seconds);
}

double node_tests(const Shape& fixed, const Place& place, const PoseSet& set) {
  const Shape mover = place.own_twin ? fixed : Shape(place.mover);
  const OverlapBatch answer = overlap(mover, set.poses, Body(fixed), {.mode = OverlapMode::any});
  return static_cast<double>(answer.cost.node_tests) / static_cast<double>(set.poses.size());
}

/// Refit against a new build, and what queries pay on each, at growing deformations.
void race_refit(const std::vector<const RuleEntry*>& chosen, const Place& place, int passes) {
  for (const RuleEntry* e : chosen) {
    ShapeOptions options;
    options.build.rule = e->rule;
    const Shape shape(place.mesh, options);
    for (const double turns : {0.0, 0.01, 0.03, 0.1, 0.3, 1.0}) {
      const auto mesh = twisted(*place.mesh, turns);
      const Shape moved = refit(shape, mesh);
      const Shape rebuilt(mesh, options);
      std::printf("%-16s %5.2f turns: degradation %5.2f; node tests refitted / new",
                  e->kebab.data(), turns, moved.sah_degradation());
      for (const PoseSet& set : place.sets) {
        std::printf("  %s %.2f", set.name.c_str(),
                    node_tests(moved, place, set) / node_tests(rebuilt, place, set));
      }
      std::printf("\n");
    }
    const double build = seconds_of([&] { const Shape rebuilt(place.mesh, options); }, passes);
    const double again = seconds_of([&] { const Shape moved = refit(shape, place.mesh); }, passes);
    std::printf("%-16s build %.1f ms, refit %.1f ms: %.2f of it\n", e->kebab.data(), 1e3 * build,
                1e3 * again, again / build);
  }
}

int number(std::string_view text) {
  int value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

void run(int argc, char** argv) {
  int passes = 7;
  bool builds = true;
  bool queries = true;
  bool threads = false;
  bool refits = false;
  bool compact = false;
  std::string_view only;
  std::vector<const RuleEntry*> chosen;
  for (int i = 1; i < argc; ++i) {
    const std::string_view arg = argv[i];
    if (arg == "--passes" && i + 1 < argc) {
      passes = std::max(1, number(argv[++i]));
    } else if (arg == "--only" && i + 1 < argc) {
      only = argv[++i];
    } else if (arg == "--no-queries") {
      queries = false;
    } else if (arg == "--no-builds") {
      builds = false;
    } else if (arg == "--threads") {
      threads = true;
    } else if (arg == "--compact") {
      compact = true;
    } else if (arg == "--refit") {
      refits = true;
    } else {
      chosen.push_back(&rule_named(arg));
    }
  }
  if (chosen.empty()) {
    for (const RuleEntry& e : rules()) {
      chosen.push_back(&e);
    }
  }
  const auto builders = builders_of(chosen);
  for (const auto& make : {&knot_place, &city_place}) {
    if (!only.empty() && only != (make == &knot_place ? "knot" : "city")) {
      continue;
    }
    const Place place = make();
    std::printf("== %s, %zu triangles\n", place.name.c_str(), place.mesh->triangles.size());
    if (builds) {
      const auto seconds = race_builds(builders, place, passes);
      for (std::size_t i = 0; i < builders.size(); ++i) {
        std::printf("%-16s %7.1f ms, least %7.1f\n", builders[i].name.c_str(),
                    1e3 * seconds[i].median, 1e3 * seconds[i].least);
      }
    }
    if (queries) {
      race_queries(kept_of(chosen, compact), place, passes);
    }
    if (threads) {
      race_threads(chosen, place, passes);
    }
    if (refits) {
      race_refit(chosen, place, passes);
    }
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace soms::bench

// build_bench [RULE...] [--passes N] [--only knot|city] [--no-builds] [--no-queries] [--threads]
// [--refit] [--compact]
int main(int argc, char** argv) {
  try {
    soms::bench::run(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
