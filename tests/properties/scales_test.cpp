// Every query at every scale, with triangles far smaller than their body, against its twin: bodies
// of 2^-1070 to 2^300, triangles of 2^0 to 2^-60 of them, sizes mixed in one mesh. Kernels are chosen
// once a process, so CMakeLists.txt runs this for each instruction set. SOMS_TEST_FACTOR multiplies
// the cases.
#include "soms/geometry/detail/double_double.h"
#include "soms/query/reference/winding.h"
#include "soms/query/winding.h"
#include "soms/scene/scene.h"

#include "tests/properties/uneven_bodies.h"
#include "tests/query/overlap_inputs.h"
#include "tests/support/closest_check.h"
#include "tests/support/needs_instruction_set.h"
#include "tests/support/probe_table.h"
#include "tests/support/query_table.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace soms {
namespace {

using test::Sizes;
using test::UnevenBodies;

/// Every so many exponents of a body's size.
constexpr int kStep = test::kSlowBuild ? 50 : 10;

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

/// Runs `body` for bodies of all sizes; the first failure ends it.
template <class Function>
void for_all_sizes(std::string_view tag, const Function& body) {
  for (const Sizes& sizes : test::all_sizes(kStep)) {
    SCOPED_TRACE("bodies of 2^" + std::to_string(sizes.body) + ", triangles of 2^" +
                 std::to_string(sizes.tiny));
    test::for_each_case(
        std::string(tag) + std::to_string(sizes.body) + "/" + std::to_string(sizes.tiny), 1,
        [&](Rng& rng) { body(sizes, rng); });
    if (testing::Test::HasFatalFailure()) {
      return;
    }
  }
}

/// Half stay where they are, since a rotation rounds away what is tiny; some rotations do not.
Pose pose_for(const UnevenBodies& bodies, Rng& rng) {
  if (rng.below(2) == 0) {
    return {};
  }
  return test::moving(test::awkward_rotation(rng), bodies.places[0], bodies.places[0]);
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
    pairs.emplace_back(contact.i, contact.j);
  }
  return pairs == truth.pairs ? "" : "a scene: other contacts than overlaps";
}

TEST_F(ScalesProperty, QueriesOfTwoBodiesAnswerAsBruteForce) {
  Tally tally;
  for_all_sizes("scales/pairs", [&](const Sizes& sizes, Rng& rng) {
    const UnevenBodies bodies = test::uneven_bodies(sizes, rng);
    const Pose pose = pose_for(bodies, rng);
    const Body a = body_of(bodies.a, pose, rng);
    const Body b = body_of(bodies.b, rng.below(2) == 0 ? pose : pose_for(bodies, rng), rng);
    ASSERT_EQ(test::first_fault(a, b), "");
    const test::PairTruth truth = test::truth_of(a, b);
    ASSERT_EQ(fault_of_batches(a, b, truth.distance.distance.upper), "");
    ASSERT_EQ(fault_of_scene(a, b, truth.overlap), "");
    for (const test::QueryRow& row : test::query_table(a, b)) {
      tally.count(std::string(row.name));
    }
    tally.count(truth.overlap.pairs.empty() ? "pairs of bodies apart" : "pairs of bodies that meet");
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
  for_all_sizes("scales/closest", [&](const Sizes& sizes, Rng& rng) {
    const UnevenBodies bodies = test::uneven_bodies(sizes, rng);
    const Body body = body_of(rng.below(4) == 0 ? bodies.b : bodies.a, pose_for(bodies, rng), rng);
    for (const Vec3& point : test::points_at(bodies, sizes, rng)) {
      ASSERT_EQ(test::first_fault_of_point(body, point), "");
      tally.count("closest and several nearest");
    }
  });
  tally.print();
  EXPECT_GT(tally.of("closest and several nearest"), 1000U);
}

TEST_F(ScalesProperty, QueriesOfPointsAnswerAsBruteForce) {
  Tally tally;
  for_all_sizes("scales/points", [&](const Sizes& sizes, Rng& rng) {
    const UnevenBodies bodies = test::uneven_bodies(sizes, rng);
    const Body body = body_of(bodies.a, pose_for(bodies, rng), rng);
    ASSERT_EQ(fault_of_probes(body, test::points_at(bodies, sizes, rng), tally), "");
  });
  tally.print();
  for (const char* kind : {"closest", "signed closest", "contains: outside", "contains: on",
                           "contains: inside"}) {
    EXPECT_GT(tally.of(kind), 100U) << kind;
  }
}

TEST_F(ScalesProperty, RaysAnswerAsBruteForce) {
  Tally tally;
  for_all_sizes("scales/rays", [&](const Sizes& sizes, Rng& rng) {
    const UnevenBodies bodies = test::uneven_bodies(sizes, rng);
    const Body body = body_of(bodies.a, pose_for(bodies, rng), rng);
    ASSERT_EQ(fault_of_probes(body, test::rays_at(bodies, sizes, rng), tally), "");
  });
  tally.print();
  for (const char* kind :
       {"closest_hit", "any_hit", "all_hits", "rays that hit", "rays that miss"}) {
    EXPECT_GT(tally.of(kind), 100U) << kind;
  }
}

/// A segment is the ray from its one end to its other, where their difference is exact.
std::string fault_of_segment(const Body& body, const Vec3& from, const Vec3& to, Tally& tally) {
  const Ray ray{from, to - from, 1};
  bool exact = !(ray.direction == Vec3{});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    exact = exact && detail::two_sum(to[axis], -from[axis]).low == 0;
  }
  if (!exact) {
    return {};
  }
  tally.count("segments");
  const ClosestHit hit = closest_hit(body, Segment{from, to});
  const ClosestHit of_ray = closest_hit(body, ray);
  return hit.triangle == of_ray.triangle && hit.t == of_ray.t && hit.point == of_ray.point
             ? ""
             : "a segment is hit otherwise than its ray";
}

TEST_F(ScalesProperty, SegmentsAreRaysOfLengthOne) {
  Tally tally;
  for_all_sizes("scales/segments", [&](const Sizes& sizes, Rng& rng) {
    const UnevenBodies bodies = test::uneven_bodies(sizes, rng);
    const Body body = body_of(bodies.a, {}, rng);
    const Vec3& corner = bodies.a.vertices[rng.below(bodies.a.vertices.size())];
    for (const Vec3& point : test::points_at(bodies, sizes, rng)) {
      ASSERT_EQ(fault_of_segment(body, {}, point, tally), "");
      ASSERT_EQ(fault_of_segment(body, corner, point, tally), "");
    }
  });
  tally.print();
  EXPECT_GT(tally.of("segments"), 1000U);
}

TEST_F(ScalesProperty, WindingNumbersHoldThoseOfBruteForce) {
  constexpr double kWidth = 1e-6;
  Tally tally;
  for_all_sizes("scales/winding", [&](const Sizes& sizes, Rng& rng) {
    const UnevenBodies bodies = test::uneven_bodies(sizes, rng);
    const Body body = body_of(bodies.a, pose_for(bodies, rng), rng);
    const WindingIndex index(body);
    const std::vector<Vec3> points = test::points_at(bodies, sizes, rng);
    const WindingBatch batch = winding(index, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Winding answer = winding(index, points[k]);
      const Bracket truth = reference::winding_by_brute_force(body, points[k]);
      ASSERT_TRUE(truth.lower <= truth.upper) << "the twin has no bracket";
      ASSERT_TRUE(answer.number.lower <= truth.upper && answer.number.upper >= truth.lower)
          << answer.number.lower << " to " << answer.number.upper << ", the twin: " << truth.lower
          << " to " << truth.upper;
      ASSERT_EQ(batch.at(k), answer);
      const bool narrow = answer.number.upper - answer.number.lower < kWidth;
      tally.count(narrow ? "winding, narrow" : "winding, wide");
    }
  });
  tally.print();
  EXPECT_GT(tally.of("winding, narrow"), 1000U);
}

}  // namespace
}  // namespace soms
