#include "soms/tree/refit.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/query/overlap.h"
#include "soms/query/reference/overlap.h"
#include "soms/thesis/overlap.h"
#include "soms/tree/build.h"
#include "soms/tree/check.h"
#include "soms/tree/layout/detail/wide_tree.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/support.h"
#include "tests/tree/inputs.h"
#include "tests/tree/layout/whole.h"

#include <cmath>
#include <limits>

namespace soms {
namespace {

ShapeOptions with_tree(Rule rule) {
  ShapeOptions options;
  options.build.rule = rule;
  options.keep_tree = true;
  return options;
}

Shape refitted(const Shape& shape, const MeshView& mesh, const Limits& limits = {}) {
  return refit(shape, std::make_shared<const Mesh>(mesh), limits);
}

/// Ways in which vertices move.
enum class Deformation { none, jitter, shuffle, collapse, flatten, far, tiny, huge };

constexpr int kDeformations = 8;

Mesh deformed(const MeshView& mesh, Deformation how, Rng& rng) {
  Mesh moved(mesh);
  for (Vec3& v : moved.vertices) {
    const Vec3 random{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    switch (how) {
      case Deformation::none:
        break;
      case Deformation::jitter:
        v += 0.1 * random;
        break;
      case Deformation::shuffle:
        v = random;
        break;
      case Deformation::collapse:
        v = {0.25, -3, 7};
        break;
      case Deformation::flatten:
        v.z = 0.5 * v.x;
        break;
      case Deformation::far:
        v += Vec3{1e8, -3e7, 2e5};
        break;
      case Deformation::tiny:
        v = 0x1p-200 * v;
        break;
      case Deformation::huge:
        v = 0x1p200 * random;
        break;
    }
  }
  return moved;
}

/// Triangles of a soup about the origin, of side 2.
Mesh soup(Rng& rng, std::size_t triangles) {
  Mesh mesh;
  for (std::size_t i = 0; i < triangles; ++i) {
    const Vec3 at{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back(
          at + 0.2 * Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TEST(Refit, GivesTheSameBytesWhereNoVertexMoved) {
  for (const RuleEntry& rule : rules()) {
    for (const test::Input input : test::kInputs) {
      for (const std::size_t count : {0U, 1U, 2U, 3U, 7U, 64U, 1000U}) {
        SCOPED_TRACE(std::string(rule.name) + ' ' + test::name(input) + ' ' +
                     std::to_string(count));
        const Shape shape(test::make_input(input, count), with_tree(rule.rule));
        const Shape again = refitted(shape, shape.mesh());
        ASSERT_EQ(again.layout(), shape.layout());
        ASSERT_EQ(*again.tree(), *shape.tree());
        ASSERT_EQ(again.bounds(), shape.bounds());
        ASSERT_EQ(again.sah_degradation(), 1);
      }
    }
  }
}

// Beyond 8192 triangles a tree is laid out in parts.
TEST(Refit, InPartsIsWholeAndTheSameForAnyNumberOfThreads) {
  Rng rng(71);
  const Mesh mesh = soup(rng, 20'000);
  for (const RuleEntry& rule : rules()) {
    SCOPED_TRACE(rule.name);
    const Shape shape(mesh, with_tree(rule.rule));
    ASSERT_EQ(refitted(shape, mesh).layout(), shape.layout());
    const Mesh moved = deformed(mesh, Deformation::jitter, rng);
    const Shape one = refitted(shape, moved);
    if (rule.rule == BuildOptions{}.rule) {
      ASSERT_NO_FATAL_FAILURE(test::expect_whole(one.layout(), moved));
    }
    ASSERT_EQ(find_fault(*one.tree(), moved), "");
    for (const int threads : {2, 3, 8}) {
      const Shape other = refitted(shape, moved, {threads, {}, {}});
      EXPECT_EQ(other.layout(), one.layout());
      EXPECT_EQ(*other.tree(), *one.tree());
    }
  }
}

// Twins cannot be divided: one node above the parts keeps more triangles than a part may have.
TEST(Refit, HoldsALeafLargerThanAPart) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {8, 0, 0}, {9, 0, 0}, {8, 1, 0}};
  mesh.triangles.resize(20'000, {0, 1, 2});
  mesh.triangles.resize(30'000, {3, 4, 5});
  ShapeOptions options{thesis_options(Rule::soms), true};
  const Shape shape(mesh, options);
  ASSERT_EQ(refitted(shape, mesh).layout(), shape.layout());
  mesh.vertices[4].z = 30;
  const Shape moved = refitted(shape, mesh);
  ASSERT_NO_FATAL_FAILURE(test::expect_whole(moved.layout(), mesh));
  EXPECT_EQ(find_fault(*moved.tree(), mesh), "");
}

TEST(Refit, HoldsEveryTriangleInsideItsBoxesWhateverMoves) {
  test::for_each_case("refit/holds", 120, [](Rng& rng) {
    const Mesh mesh = soup(rng, 1 + rng.below(300));
    ShapeOptions options = with_tree(static_cast<Rule>(rng.below(rules().size())));
    options.build.per_leaf = static_cast<int>(1 + rng.below(20));
    Shape shape(mesh, options);
    for (int step = 0; step < 2; ++step) {
      const Mesh moved = deformed(shape.mesh(), Deformation(rng.below(kDeformations)), rng);
      shape = refitted(shape, moved);
      ASSERT_NO_FATAL_FAILURE(test::expect_whole(shape.layout(), moved));
      ASSERT_EQ(find_fault(*shape.tree(), moved), "");
      ASSERT_EQ(shape.bounds(), bounds(moved));
    }
  });
}

TEST(Refit, AnswersAsANewBuildAndAsBruteForce) {
  test::for_each_case("refit/answers", 60, [](Rng& rng) {
    const Mesh mesh = soup(rng, 1 + rng.below(200));
    const auto how = Deformation(rng.below(kDeformations));
    const Mesh moved = deformed(mesh, how, rng);
    const Body other{Shape(soup(rng, 100)), Pose::about_z(rng.uniform(0, 6), {0.5, 0, 0})};
    Body body{
        refitted(Shape(mesh, with_tree(static_cast<Rule>(rng.below(rules().size())))), moved)};
    const Box box = body.shape.bounds();
    if (how == Deformation::far || how == Deformation::collapse) {
      const Vec3 to = -1 * box.center();
      body.pose = Pose::translation(to.x, to.y, to.z);
    }
    const Overlap answer = overlap(body, other);
    EXPECT_EQ(answer.pairs,
              reference::overlap(moved, body.pose, other.shape.mesh(), other.pose).pairs);
    EXPECT_EQ(answer.pairs, overlap(Body{Shape(moved), body.pose}, other).pairs);
    EXPECT_EQ(overlap(body, other, {.mode = OverlapMode::any}).any, answer.any);
    const Body by_soms{Shape(other.shape.shared_mesh(), with_tree(Rule::soms)), other.pose};
    EXPECT_EQ(thesis::overlap(body, by_soms, {.traversal = Traversal::e_node}).answer.pairs,
              answer.pairs);
  });
}

TEST(Refit, LeavesTheShapeItIsMadeFromAsItWas) {
  const Shape shape(generate_sphere(80));
  const Box before = shape.bounds();
  std::vector<Vec3> vertices = shape.shared_mesh()->vertices;
  for (Vec3& v : vertices) {
    v.x *= 10;
  }
  const Shape moved = refit(shape, vertices);
  EXPECT_EQ(shape.bounds(), before);
  EXPECT_EQ(moved.shared_mesh()->vertices, vertices);
  EXPECT_EQ(moved.bounds().upper.x, 10 * before.upper.x);
  EXPECT_EQ(moved.shared_mesh()->triangles, shape.shared_mesh()->triangles);
  EXPECT_EQ(moved.mesh().source, shape.mesh().source);
}

TEST(Refit, SaysHowFarTheTreeHasFallenBehind) {
  Rng rng(7);
  const Mesh mesh = soup(rng, 20'000);
  const Shape shape(mesh);
  EXPECT_EQ(shape.sah_degradation(), 1);
  EXPECT_FALSE(build_is_due(shape));
  const Shape scaled = refitted(shape, deformed(mesh, Deformation::tiny, rng));
  EXPECT_NEAR(scaled.sah_degradation(), 1, 1e-3);
  // Triangles stay as they are and leave their neighbors.
  Mesh scattered = mesh;
  for (const auto& corners : mesh.triangles) {
    const Vec3 by{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    for (const std::uint32_t corner : corners) {
      scattered.vertices[corner] += by;
    }
  }
  const Shape shuffled = refitted(shape, scattered);
  EXPECT_GT(shuffled.sah_degradation(), 3);
  EXPECT_TRUE(build_is_due(shuffled));
  // It compares with the build, not with the refit before.
  const Shape twice = refitted(shuffled, shuffled.mesh());
  EXPECT_EQ(twice.sah_degradation(), shuffled.sah_degradation());
  EXPECT_EQ(refitted(shuffled, mesh).sah_degradation(), 1);
  EXPECT_EQ(refitted(shape, deformed(mesh, Deformation::collapse, rng)).sah_degradation(), 1);
}

// A tree that was built while all vertices were in one place knows nothing of where they went.
TEST(Refit, OfAShapeThatHadNoAreaIsDueForABuild) {
  Rng rng(7);
  const Mesh mesh = soup(rng, 2000);
  const Shape folded(deformed(mesh, Deformation::collapse, rng));
  EXPECT_EQ(refitted(folded, folded.mesh()).sah_degradation(), 1);
  const Shape unfolded = refitted(folded, mesh);
  EXPECT_TRUE(build_is_due(unfolded));
  EXPECT_TRUE(build_is_due(refitted(unfolded, mesh)));
  EXPECT_FALSE(build_is_due(refitted(unfolded, folded.mesh())));
}

ErrorKind kind_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "accepted";
  return {};
}

TEST(Refit, KeepsAllThatTheMeshStates) {
  Mesh mesh = generate_sphere(80);
  mesh.unit = 0.001;
  mesh.up = UpAxis::y;
  mesh.georeference.crs = "EPSG:25833";
  mesh.source = "ball.ply";
  mesh.notes = {"a note"};
  mesh.parts = {Part{"ball", Part::kNoParent, 0, 80}};
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    mesh.faces.push_back(i / 2);
  }
  EXPECT_EQ(refit(Shape(mesh), mesh.vertices).mesh(), mesh);
}

TEST(Refit, RefusesWhatIsNotTheSameMeshMoved) {
  const Shape shape(generate_sphere(80), with_tree(Rule::soms));
  std::vector<Vec3> vertices = shape.shared_mesh()->vertices;
  vertices[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(kind_of([&] { static_cast<void>(refit(shape, vertices)); }), ErrorKind::not_finite);
  vertices[3].y = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(kind_of([&] { static_cast<void>(refit(shape, vertices)); }), ErrorKind::not_finite);
  vertices[3].y = 0x1p301;
  EXPECT_EQ(kind_of([&] { static_cast<void>(refit(shape, vertices)); }), ErrorKind::out_of_range);
  vertices.pop_back();
  EXPECT_EQ(kind_of([&] { static_cast<void>(refit(shape, vertices)); }), ErrorKind::usage);
  Mesh other(shape.mesh());
  std::swap(other.triangles[0], other.triangles[1]);
  EXPECT_EQ(kind_of([&] { static_cast<void>(refitted(shape, other)); }), ErrorKind::usage);
  other.triangles.pop_back();
  EXPECT_EQ(kind_of([&] { static_cast<void>(refitted(shape, other)); }), ErrorKind::usage);
  EXPECT_EQ(kind_of([&] { static_cast<void>(refit(*shape.tree(), other)); }), ErrorKind::usage);
  const std::shared_ptr<const Mesh> none;
  EXPECT_EQ(kind_of([&] { static_cast<void>(refit(shape, none)); }), ErrorKind::usage);
  EXPECT_EQ(kind_of([&] { static_cast<void>(Shape(none)); }), ErrorKind::usage);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(kind_of([&] {
              static_cast<void>(refitted(shape, shape.mesh(), {1, stop.get_token(), {}}));
            }),
            ErrorKind::cancelled);
}

}  // namespace
}  // namespace soms
