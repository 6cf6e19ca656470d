// Every row of the tables of questions at every scale, with triangles far smaller than their body,
// against its twin. ray_scales_test.cpp has segments and winding numbers. Kernels are chosen once a
// process, so CMakeLists.txt runs this for each instruction set. SOMS_TEST_FACTOR multiplies the
// cases.
#include "tests/support/scales.h"

#include "soms/scene/scene.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/needs_instruction_set.h"
#include "tests/support/support.h"
#include "tests/support/truth/closest_check.h"
#include "tests/support/truth/probe_table.h"
#include "tests/support/truth/query_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace soms {
namespace {

using test::Scales;

/// How often each kind of answer was compared.
class Tally {
 public:
  void count(const std::string& kind) { ++counts_[kind]; }

  [[nodiscard]] std::uint64_t of(const std::string& kind) const {
    const auto found = counts_.find(kind);
    return found == counts_.end() ? 0 : found->second;
  }

  void print() const {
    std::uint64_t sum = 0;
    for (const auto& [kind, count] : counts_) {
      std::cout << "  " << kind << ": " << count << '\n';
      sum += count;
    }
    std::cout << "  in all: " << sum << " answers, by " << instruction_set() << '\n';
  }

 private:
  std::map<std::string, std::uint64_t> counts_;
};

/// Calls `check` for all pairs of scales; the first failure ends it.
template <class Function>
void for_all_scales(std::string_view tag, const Function& check) {
  std::size_t number = 0;
  test::for_each_case(tag, static_cast<int>(test::count_of_scales()), [&](Rng& rng) {
    const Scales scales = test::scales_of(number++);
    SCOPED_TRACE("body of 2^" + std::to_string(scales.body) + ", triangles of 2^" +
                 std::to_string(scales.triangle));
    check(scales, rng);
  });
}

/// Half stay where they are, since a rotation rounds away what is tiny.
Pose pose_for(const Scales& scales, Rng& rng) {
  return rng.below(2) == 0 ? Pose{} : test::pose_at(rng, scales);
}

Mesh mesh_at(const Scales& scales, bool solids, Rng& rng) {
  return solids ? test::uneven_solids(rng, scales) : test::uneven_mesh(rng, scales);
}

/// Points on, beside and near small triangles of a body.
std::vector<Vec3> points_at(const Body& body, const Scales& scales, Rng& rng) {
  const auto on = [&] { return test::point_of_small(rng, body.shape.mesh(), body.pose); };
  const double small = std::exp2(std::min(scales.triangle + rng.uniform(-2, 3), scales.body - 2.0));
  Vec3 beside = on();
  double& x = beside[rng.below(3)];
  x = std::nextafter(x, rng.below(2) == 0 ? -1e300 : 1e300);
  return {on(), beside, on() + test::any_way(rng, small),
          on() + test::any_way(rng, std::exp2(scales.body - 2))};
}

/// Rays between such points, and in any direction.
std::vector<Ray> rays_at(const Body& body, const Scales& scales, Rng& rng) {
  const std::vector<Vec3> from = points_at(body, scales, rng);
  const std::vector<Vec3> to = points_at(body, scales, rng);
  std::vector<Ray> rays;
  for (std::size_t k = 0; k < from.size(); ++k) {
    const Vec3 way = rng.below(4) == 0 ? test::any_way(rng, 1) : to[k] - from[k];
    if (way != Vec3{}) {
      rays.push_back(
          {from[k], way, rng.below(3) == 0 ? 1 : std::numeric_limits<double>::infinity()});
    }
  }
  return rays;
}

Body body_of(const Mesh& mesh, const Pose& pose, Rng& rng) {
  return Body(Shape(mesh, {.build = test::awkward_options(rng),
                           .layout = rng.below(3) == 0 ? Layout::compact : Layout::wide}),
              pose);
}

class ScalesProperty : public test::NeedsInstructionSet {};

/// Columns of a batch are what single queries say.
std::string fault_of_batches(const Body& a, const Body& b, double length) {
  const std::array<Pose, 3> poses{a.pose, Pose(), a.pose};
  for (const test::QueryRow& row : test::query_table()) {
    if (row.of_closed_bodies) {
      continue;  // Pose() may open a body
    }
    const test::RowOptions options{.length = length};
    const test::BatchAnswer batch = row.ask_batch(a.shape, poses, b, options, {.threads = 2});
    for (std::size_t k = 0; k < poses.size(); ++k) {
      if (!(batch.answers[k] == row.ask(Body(a.shape, poses[k]), b, options, {}))) {
        return std::string(row.name) + ": another answer in a batch";
      }
    }
  }
  return {};
}

/// A mover in a scene touches what it overlaps.
std::string fault_of_scene(const Body& a, const Body& b, const Overlap& truth) {
  Scene scene;
  scene.add_environment(b);
  scene.add_mover(a);
  const StepReport report = scene.step();
  std::vector<TrianglePair> pairs;
  for (const EnvironmentContact& contact : report.environment) {
    pairs.push_back({contact.i, contact.j});
  }
  return pairs == truth.pairs ? "" : "a scene: other contacts than overlaps";
}

TEST_F(ScalesProperty, QueriesOfTwoBodiesAnswerAsBruteForce) {
  Tally tally;
  for_all_scales("scales/pairs", [&](const Scales& scales, Rng& rng) {
    const bool solids = rng.below(2) == 0;
    const Mesh mesh = mesh_at(scales, solids, rng);
    const Pose pose = pose_for(scales, rng);
    const Body a = body_of(mesh, pose, rng);
    const Body b = body_of(test::uneven_beside(rng, scales, mesh, solids),
                           rng.below(4) == 0 ? pose_for(scales, rng) : pose, rng);
    ASSERT_EQ(test::first_fault(a, b), "");
    const test::PairTruth truth = test::truth_of(a, b);
    ASSERT_EQ(fault_of_batches(a, b, truth.distance.distance.upper), "");
    ASSERT_EQ(fault_of_scene(a, b, truth.overlap), "");
    for (const test::QueryRow& row : test::query_table(a, b)) {
      tally.count(std::string(row.name));
    }
    tally.count(truth.overlap.pairs.empty() ? "pairs of bodies apart"
                                            : "pairs of bodies that meet");
  });
  tally.print();
  for (const char* kind : {"overlap", "overlap any", "overlap first", "distance", "within", "solid",
                           "pairs of bodies apart", "pairs of bodies that meet"}) {
    EXPECT_GT(tally.of(kind), 100U) << kind;
  }
}

std::string name_of(Side side) {
  constexpr std::array<const char*, 4> kNames{"outside", "inside", "on", "undecided"};
  return kNames.at(static_cast<std::size_t>(side));
}

/// Compares each row with its twin, and batches with single queries.
template <class Probe>
std::string fault_of_probes(const Body& body, const std::vector<Probe>& probes, Tally& tally) {
  for (const test::ProbeRow<Probe>& row : test::probe_table<Probe>(body)) {
    const test::BatchAnswer batch = row.ask_batch(body, probes, {}, {.threads = 2});
    for (std::size_t k = 0; k < probes.size(); ++k) {
      const test::Answer answer = row.ask(body, probes[k], {});
      const test::Answer truth = row.twin(body, probes[k], {});
      if (!(row.promised(answer) == row.promised(truth))) {
        return std::string(row.name) + ", probe " + std::to_string(k) + ": " + row.text(answer) +
               ", the twin: " + row.text(truth);
      }
      if (!(batch.answers[k] == answer)) {
        return std::string(row.name) + ": another answer in a batch";
      }
      tally.count(std::string(row.name));
      if (const auto* const side = std::get_if<Contains>(&truth)) {
        tally.count("contains: " + name_of(side->side));
      } else if (const auto* const any = std::get_if<AnyHit>(&truth)) {
        tally.count(any->hit ? "rays that hit" : "rays that miss");
      }
    }
  }
  return {};
}

TEST_F(ScalesProperty, NearestTrianglesOfPointsAreThoseOfBruteForce) {
  Tally tally;
  for_all_scales("scales/closest", [&](const Scales& scales, Rng& rng) {
    const Body body = body_of(mesh_at(scales, false, rng), pose_for(scales, rng), rng);
    for (const Vec3& point : points_at(body, scales, rng)) {
      ASSERT_EQ(test::first_fault_of_point(body, point), "");
      tally.count("closest and several nearest");
    }
  });
  tally.print();
  EXPECT_GT(tally.of("closest and several nearest"), 1000U);
}

TEST_F(ScalesProperty, QueriesOfPointsAnswerAsBruteForce) {
  Tally tally;
  for_all_scales("scales/points", [&](const Scales& scales, Rng& rng) {
    const Body body = body_of(mesh_at(scales, true, rng), pose_for(scales, rng), rng);
    ASSERT_EQ(fault_of_probes(body, points_at(body, scales, rng), tally), "");
  });
  tally.print();
  for (const char* kind :
       {"closest", "signed closest", "contains: outside", "contains: on", "contains: inside"}) {
    EXPECT_GT(tally.of(kind), 100U) << kind;
  }
}

TEST_F(ScalesProperty, RaysAnswerAsBruteForce) {
  Tally tally;
  for_all_scales("scales/rays", [&](const Scales& scales, Rng& rng) {
    const Body body = body_of(mesh_at(scales, false, rng), pose_for(scales, rng), rng);
    ASSERT_EQ(fault_of_probes(body, rays_at(body, scales, rng), tally), "");
  });
  tally.print();
  for (const char* kind :
       {"closest_hit", "any_hit", "all_hits", "rays that hit", "rays that miss"}) {
    EXPECT_GT(tally.of(kind), 100U) << kind;
  }
}

}  // namespace
}  // namespace soms
