// Queries of trees by the rule `quick`, which come of codes and not of boxes: every question equals
// its twin on meshes that try the codes.
#include "tests/query/overlap_inputs.h"
#include "tests/support/needs_instruction_set.h"
#include "tests/support/support.h"
#include "tests/support/truth/probe_table.h"
#include "tests/support/truth/query_table.h"
#include "tests/tree/inputs.h"

#include <array>
#include <cmath>
#include <memory>
#include <string>

namespace soms {
namespace {

using QuickTrees = test::NeedsInstructionSet;

Body quick(const Body& body, int per_leaf) {
  const BuildOptions options{.rule = Rule::quick, .per_leaf = per_leaf};
  return Body(Shape(body.shape.shared_mesh(), {options}), body.pose);
}

Body quick(Mesh mesh, int per_leaf) {
  return quick(Body(std::move(mesh)), per_leaf);
}

/// Both by `quick`, then one beside a tree by any other rule.
void expect_twins_by_quick(Rng& rng, const test::Two& two) {
  static constexpr std::array<int, 4> kLeaves{1, 2, 8, 100};
  const Body a = quick(two.a, kLeaves[rng.below(4)]);
  const Body b = quick(two.b, kLeaves[rng.below(4)]);
  ASSERT_EQ(test::first_fault(a, b), "");
  ASSERT_EQ(test::first_fault_of_overlap(a, two.b), "");
}

template <class Probe>
void expect_probe_twins(const Body& body, const std::vector<Probe>& probes) {
  for (const auto& row : test::probe_table<Probe>(body)) {
    for (const Probe& probe : probes) {
      ASSERT_EQ(row.promised(row.ask(body, probe, {})), row.twin(body, probe, {})) << row.name;
    }
  }
}

/// Every question about points, rays, and another body that touches this one at a corner.
void expect_every_twin(const Body& body) {
  const test::Probes probes = test::probes_of(body, 2);
  ASSERT_NO_FATAL_FAILURE(expect_probe_twins(body, probes.points));
  ASSERT_NO_FATAL_FAILURE(expect_probe_twins(body, probes.rays));
  const MeshView& mesh = body.shape.mesh();
  Body other = body;
  other.pose = test::moving({}, mesh.vertices.front(), mesh.vertices.back());
  ASSERT_EQ(test::first_fault(body, other), "");
}

TEST_F(QuickTrees, EqualTheTwinsOnBodiesThatMayTouch) {
  test::for_each_case("quick/usual", 60, [](Rng& rng) {
    expect_twins_by_quick(rng, test::likely_to_meet(rng, 60, 1, rng.uniform(0.1, 1), 0));
  });
}

TEST_F(QuickTrees, EqualTheTwinsWhereSizesAndPlacesDiffer) {
  test::for_each_case("quick/sizes", 40, [](Rng& rng) {
    expect_twins_by_quick(rng, test::likely_to_meet(rng, 40, 1, std::exp2(-rng.uniform(0, 60)), 0));
  });
  test::for_each_case("quick/far", 40, [](Rng& rng) {
    expect_twins_by_quick(rng, test::likely_to_meet(rng, 40, 1, 1, std::exp2(rng.uniform(0, 60))));
  });
}

// From numbers that are subnormal to the largest that a body may have.
TEST_F(QuickTrees, EqualTheTwinsAtEveryScale) {
  test::for_each_case("quick/scales", 60, [](Rng& rng) {
    const double scale = std::exp2(rng.uniform(-1070, 297));
    expect_twins_by_quick(rng, test::likely_to_meet(rng, 30, scale, scale, 0));
  });
}

TEST_F(QuickTrees, EqualTheTwinsOnMeshesOfEveryKind) {
  for (const test::Input input : test::kInputs) {
    for (const std::size_t size : {std::size_t{1}, std::size_t{2}, std::size_t{17}}) {
      SCOPED_TRACE(test::name(input) + " " + std::to_string(size));
      ASSERT_NO_FATAL_FAILURE(expect_every_twin(quick(test::make_input(input, size), 1)));
      ASSERT_NO_FATAL_FAILURE(expect_every_twin(quick(test::make_input(input, size), 8)));
    }
  }
}

// One code for all but one triangle; corners at both ends of what is allowed; a flat mesh; a line.
TEST_F(QuickTrees, EqualTheTwinsWhereCodesSayLittle) {
  const Mesh usual = test::make_input(test::Input::random, 20);
  Mesh far = usual;
  const auto first = static_cast<std::uint32_t>(far.vertices.size());
  far.vertices.insert(far.vertices.end(), {{1e15, 0, 0}, {1e15, 1, 0}, {1e15, 0, 1}});
  far.triangles.push_back({first, first + 1, first + 2});
  Mesh extreme = usual;
  extreme.vertices[0] = {0x1p298, -0x1p298, 0x1p298};
  extreme.vertices[4] = {-0x1p298, 0x1p298, -0x1p298};
  extreme.vertices[8] = {0x1p-1074, -0.0, 0};
  Mesh flat = usual;
  Mesh line = usual;
  for (std::size_t i = 0; i < usual.vertices.size(); ++i) {
    flat.vertices[i].z = -0.0;
    line.vertices[i].y = line.vertices[i].z = 7;
  }
  for (const Mesh& mesh : {far, extreme, flat, line}) {
    ASSERT_NO_FATAL_FAILURE(expect_every_twin(quick(mesh, 2)));
  }
}

}  // namespace
}  // namespace soms
