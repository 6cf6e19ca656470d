#include "soms/base/error.h"
#include "soms/scene/scene.h"
#include "soms/tree/refit.h"

#include "tests/scene/random_bodies.h"
#include "tests/scene/scenes.h"
#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace soms {

namespace {

constexpr Box kCube{{0, 0, 0}, {1, 1, 1}};

Shape cube() {
  return Shape(test::box_mesh(kCube));
}

Body cube_at(double x) {
  return Body(cube(), Pose::translation(x, 0, 0));
}

/// Two scenes that undergo the same random changes, and what is excluded in both.
class Changing {
 public:
  explicit Changing(Rng& rng) : rng_(rng) {
    for (int k = 0; k < 3; ++k) {
      shapes_.emplace_back(test::random_mesh(rng));
    }
    shapes_.emplace_back();
    for (int k = 0; k < 12; ++k) {
      add_mover();
    }
    for (int k = 0; k < 4; ++k) {
      add_part();
    }
  }

  Scene kept;
  Scene fresh;
  test::Exclusions exclusions;

  void change() {
    static constexpr std::array kChanges{
        &Changing::add_mover,   &Changing::remove_mover,    &Changing::add_part,
        &Changing::remove_part, &Changing::exclude_movers,  &Changing::exclude_part,
        &Changing::set_group,   &Changing::set_mover_shape, &Changing::set_part_shape,
        &Changing::set_poses,   &Changing::set_one_place,
    };
    (this->*kChanges[rng_.below(kChanges.size())])();
  }

 private:
  template <typename Change>
  void both(const Change& change) {
    change(kept);
    change(fresh);
  }

  template <typename Id>
  const Id* any_of(const std::vector<Id>& ids) {
    return ids.empty() ? nullptr : &ids[rng_.below(ids.size())];
  }

  Pose pose() { return test::random_pose(rng_, 6); }

  Shape shape() { return shapes_[rng_.below(shapes_.size())]; }

  std::uint32_t group() { return static_cast<std::uint32_t>(rng_.below(4)); }

  void add_mover() {
    const Body body(shape(), pose());
    const std::uint32_t in = group();
    MoverId id = 0;
    both([&](Scene& scene) { id = scene.add_mover(body, in); });
    exclusions.groups[id] = in;
  }

  void remove_mover() {
    const std::vector<MoverId> ids = kept.movers();
    if (const MoverId* const id = any_of(ids)) {
      both([&](Scene& scene) { scene.remove_mover(*id); });
    }
  }

  void add_part() {
    const Body body(shape(), pose());
    both([&](Scene& scene) { scene.add_environment(body); });
  }

  void remove_part() {
    const std::vector<EnvironmentId> ids = kept.environments();
    if (const EnvironmentId* const id = any_of(ids)) {
      both([&](Scene& scene) { scene.remove_environment(*id); });
    }
  }

  void exclude_movers() {
    const std::vector<MoverId> ids = kept.movers();
    for (int k = 0; k < 4 && ids.size() > 1; ++k) {
      const MoverId a = *any_of(ids);
      const MoverId b = *any_of(ids);
      const std::pair<MoverId, MoverId> pair = std::minmax(a, b);
      if (a != b && rng_.below(3) != 0) {
        both([&](Scene& scene) { scene.ignore(a, b); });
        exclusions.movers.insert(pair);
      } else if (a != b) {
        both([&](Scene& scene) { scene.unignore(a, b); });
        exclusions.movers.erase(pair);
      }
    }
  }

  void exclude_part() {
    const std::vector<MoverId> movers = kept.movers();
    const std::vector<EnvironmentId> parts = kept.environments();
    if (movers.empty() || parts.empty()) {
      return;
    }
    const MoverId mover = *any_of(movers);
    const EnvironmentId part = *any_of(parts);
    if (rng_.below(3) != 0) {
      both([&](Scene& scene) { scene.ignore_environment(mover, part); });
      exclusions.parts.insert({mover, part});
    } else {
      both([&](Scene& scene) { scene.unignore_environment(mover, part); });
      exclusions.parts.erase({mover, part});
    }
  }

  void set_group() {
    const std::vector<MoverId> ids = kept.movers();
    if (const MoverId* const id = any_of(ids)) {
      const std::uint32_t in = group();
      both([&](Scene& scene) { scene.set_group(*id, in); });
      exclusions.groups[*id] = in;
    }
  }

  /// Another shape, or the body's own with moved vertices.
  Shape changed(const Shape& before) {
    if (rng_.below(2) == 0) {
      return shape();
    }
    std::vector<Vec3> vertices = before.shared_mesh()->vertices;
    for (Vec3& v : vertices) {
      v.x += static_cast<double>(rng_.below(3)) - 1;
    }
    return refit(before, std::move(vertices));
  }

  void set_mover_shape() {
    const std::vector<MoverId> ids = kept.movers();
    if (const MoverId* const id = any_of(ids)) {
      const Shape next = changed(kept.mover(*id).shape);
      both([&](Scene& scene) { scene.set_shape(*id, next); });
    }
  }

  void set_part_shape() {
    const std::vector<EnvironmentId> ids = kept.environments();
    if (const EnvironmentId* const id = any_of(ids)) {
      const Shape next = changed(kept.environment(*id).shape);
      both([&](Scene& scene) { scene.set_environment_shape(*id, next); });
    }
  }

  void set_poses() {
    for (const MoverId id : kept.movers()) {
      const Pose next = pose();
      both([&](Scene& scene) { scene.set_pose(id, next); });
    }
  }

  void set_one_place() {
    const Pose next = pose();
    for (const MoverId id : kept.movers()) {
      if (id % 3 != 0) {
        both([&](Scene& scene) { scene.set_pose(id, next); });
      }
    }
  }

  Rng& rng_;
  std::vector<Shape> shapes_;
};

// Groups, ignored pairs, poses, shapes and bodies change between steps; each report is that of a
// scan.
TEST(SceneChanges, AreInTheNextReportAsAScanFinds) {
  std::size_t contacts = 0;
  std::size_t excluded = 0;
  test::for_each_case("scene/changes", 60, [&](Rng& rng) {
    Changing scenes(rng);
    for (int step = 0; step < 15; ++step) {
      const StepReport expected = test::scan(scenes.kept, scenes.exclusions);
      const int threads = std::array{1, 2, 4}[rng.below(3)];
      const StepReport kept = scenes.kept.step({}, Limits{.threads = threads});
      const StepReport fresh = scenes.fresh.step({.coherent = false});
      ASSERT_EQ(kept.environment, expected.environment) << "step " << step;
      ASSERT_EQ(kept.movers, expected.movers) << "step " << step;
      ASSERT_EQ(fresh.environment, expected.environment) << "step " << step;
      ASSERT_EQ(fresh.movers, expected.movers) << "step " << step;
      ASSERT_EQ(kept.box_pairs, fresh.box_pairs);
      ASSERT_EQ(kept.queries, fresh.queries);
      ASSERT_EQ(kept.cost, fresh.cost);
      contacts += kept.environment.size() + kept.movers.size();
      excluded += scenes.exclusions.movers.size() + scenes.exclusions.parts.size();
      for (std::uint64_t k = rng.below(4); k > 0; --k) {
        scenes.change();
      }
    }
  });
  EXPECT_GT(contacts, 10000U);
  EXPECT_GT(excluded, 1000U);
}

TEST(SceneChanges, OfAShapeKeepNumberPoseNameGroupAndWhatIsIgnored) {
  Scene scene;
  const EnvironmentId wall = scene.add_environment(cube_at(0.5));
  const EnvironmentId floor = scene.add_environment(cube_at(-0.5));
  Body arm = cube_at(0);
  arm.name = "arm";
  const MoverId a = scene.add_mover(arm, 3);
  const MoverId b = scene.add_mover(cube_at(0.25), 3);
  const MoverId c = scene.add_mover(cube_at(0.25));
  const MoverId d = scene.add_mover(cube_at(0.25));
  scene.ignore(a, c);
  scene.ignore_environment(a, wall);
  static_cast<void>(scene.step());
  scene.set_shape(a, Shape(test::box_mesh({{-1, -1, -1}, {2, 2, 2}})));
  scene.set_environment_shape(wall, Shape(test::box_mesh({{-3, 0, 0}, {3, 1, 1}})));
  EXPECT_EQ(scene.mover(a).name, "arm");
  EXPECT_EQ(scene.mover(a).pose, arm.pose);
  EXPECT_EQ(scene.environment(wall).pose, Pose::translation(0.5, 0, 0));
  test::Exclusions exclusions;
  exclusions.groups = {{a, 3}, {b, 3}};
  exclusions.movers = {{a, c}};
  exclusions.parts = {{a, wall}};
  const StepReport expected = test::scan(scene, exclusions);
  const StepReport report = scene.step();
  EXPECT_EQ(report.environment, expected.environment);
  EXPECT_EQ(report.movers, expected.movers);
  EXPECT_EQ(report.shapes_set, 2U);
  EXPECT_EQ(report.queries, 11U);  // a: floor, d; b, c, d: wall, floor; b and c, b and d, c and d
  EXPECT_EQ(scene.movers(), (std::vector<MoverId>{a, b, c, d}));
  EXPECT_EQ(scene.environments(), (std::vector<EnvironmentId>{wall, floor}));
}

// The box goes with the shape: of a body that grew, and of one that shrank.
TEST(SceneChanges, OfAShapeMoveItsBox) {
  Scene scene;
  const EnvironmentId part = scene.add_environment(cube_at(5));
  const MoverId mover = scene.add_mover(cube_at(0));
  const MoverId other = scene.add_mover(cube_at(-5));
  EXPECT_EQ(scene.step().box_pairs, 0U);
  scene.set_shape(mover, Shape(test::box_mesh({{-9, 0.25, 0.25}, {9, 0.5, 0.5}})));
  EXPECT_EQ(scene.step().box_pairs, 2U);
  EXPECT_EQ(scene.step().touching_movers(), (std::vector<MoverId>{mover, other}));
  scene.set_shape(mover, cube());
  EXPECT_EQ(scene.step().box_pairs, 0U);
  scene.set_environment_shape(part, Shape(test::box_mesh({{-5, 0.25, 0.25}, {-4.5, 0.5, 0.5}})));
  EXPECT_EQ(scene.step().box_pairs, 1U);
  scene.set_shape(mover, Shape());
  EXPECT_EQ(scene.step().box_pairs, 0U);
}

TEST(SceneChanges, OfAShapeThatCannotBePosedLeaveTheOldOne) {
  Scene scene;
  Body van = Body(cube(), Pose::translation(0x1p300, 0, 0));
  van.name = "van";
  const MoverId mover = scene.add_mover(van);
  const EnvironmentId part = scene.add_environment(van);
  const std::uint64_t before = scene.step().hash();
  const Shape far(test::box_mesh({{0x1p299, 0, 0}, {0x1p300, 1, 1}}));
  const auto refused = [&](const auto& change, const std::string& name) {
    try {
      change();
    } catch (const Error& error) {
      return error.kind() == ErrorKind::out_of_range &&
             std::string(error.what()).find(name) != std::string::npos;
    }
    return false;
  };
  EXPECT_TRUE(refused([&] { scene.set_shape(mover, far); }, "mover 0 (van)"));
  EXPECT_TRUE(
      refused([&] { scene.set_environment_shape(part, far); }, "part of the environment 0 (van)"));
  EXPECT_THROW(scene.set_shape(7, cube()), Error);
  EXPECT_THROW(scene.set_environment_shape(7, cube()), Error);
  EXPECT_EQ(&scene.mover(mover).shape.mesh(), &van.shape.mesh());
  EXPECT_EQ(&scene.environment(part).shape.mesh(), &van.shape.mesh());
  EXPECT_EQ(scene.step().hash(), before);
  EXPECT_EQ(scene.step().shapes_set, 0U);
}

TEST(SceneChanges, OfGroupsAndIgnoredPairsHoldFromTheNextStepOn) {
  Scene scene;
  const EnvironmentId part = scene.add_environment(cube_at(0.5));
  const MoverId a = scene.add_mover(cube_at(0), 1);
  const MoverId b = scene.add_mover(cube_at(0.25), 1);
  EXPECT_TRUE(scene.step().movers.empty());
  scene.set_group(b, 2);
  EXPECT_FALSE(scene.step().movers.empty());
  scene.ignore(b, a);
  EXPECT_TRUE(scene.step().movers.empty());
  scene.unignore(a, b);
  scene.unignore(a, b);
  EXPECT_FALSE(scene.step().movers.empty());
  scene.set_group(a, 2);
  EXPECT_TRUE(scene.step().movers.empty());
  scene.set_group(a, 0);
  scene.set_group(b, 0);
  EXPECT_FALSE(scene.step().movers.empty());
  scene.ignore_environment(a, part);
  scene.ignore_environment(b, part);
  EXPECT_TRUE(scene.step().environment.empty());
  scene.unignore_environment(b, part);
  EXPECT_EQ(scene.step().environment.front().mover, b);
  EXPECT_THROW(scene.set_group(9, 1), Error);
  EXPECT_THROW(scene.unignore(a, 9), Error);
  EXPECT_THROW(scene.unignore_environment(9, part), Error);
}

// Whatever allocation of the step after a change fails, the next step knows of the change.
TEST(SceneChanges, AreNotLostWhereMemoryRunsShort) {
  std::uint64_t failures = 0;
  for (std::uint64_t lasting = 0, failed = 1; failed != 0; ++lasting, failures += failed) {
    failed = 0;
    Scene scene;
    test::Exclusions exclusions;
    for (MoverId k = 0; k < 8; ++k) {
      scene.add_mover(cube_at(0.1 * k), k % 3);
      exclusions.groups[k] = k % 3;
    }
    scene.add_environment(cube_at(0));
    static_cast<void>(scene.step());
    scene.set_group(0, 2);
    exclusions.groups[0] = 2;
    scene.ignore(7, 1);
    exclusions.movers = {{1, 7}};
    scene.set_environment_shape(0, Shape(test::box_mesh({{0, 0, 0}, {0.25, 1, 1}})));
    try {
      const test::AllocationFault fault(lasting);
      static_cast<void>(scene.step({.scope = StepScope::first_contact}));
    } catch (const std::bad_alloc&) {
      failed = 1;
    }
    const StepReport expected = test::scan(scene, exclusions);
    const StepReport report = scene.step();
    ASSERT_EQ(report.environment, expected.environment) << lasting;
    ASSERT_EQ(report.movers, expected.movers) << lasting;
  }
  EXPECT_GT(failures, 10U);
}

}  // namespace

}  // namespace soms
