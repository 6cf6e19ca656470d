// Swept steps equal the first contacts of all pairs of bodies.
#include "soms/generate/shapes.h"
#include "soms/scene/scene.h"

#include "tests/scene/passages_twin.h"
#include "tests/scene/random_bodies.h"
#include "tests/scene/swept_scenes.h"
#include "tests/support/support.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace soms {

namespace {

using test::Scenes;

/// What a test does to scenes between two steps, and the ways that follow.
class Changes {
 public:
  Changes(Rng& rng, double reach, const Vec3& origin) : rng_(rng), reach_(reach), origin_(origin) {}

  [[nodiscard]] Pose pose() const {
    Pose pose = test::random_pose(rng_, reach_);
    for (std::size_t row = 0; row < 3; ++row) {
      pose.m[4 * row + 3] += origin_[row];
    }
    return pose;
  }

  void begin(Scenes& scenes) {
    const std::uint64_t bodies = 2 + rng_.below(6);
    for (std::uint64_t k = 0; k < bodies; ++k) {
      const Body body(Shape(test::random_mesh(rng_)), pose());
      const bool moves = rng_.below(4) != 0;
      scenes.change([&](Scene& scene) {
        if (moves) {
          scene.add_mover(body);
        } else {
          scene.add_environment(body);
        }
      });
    }
  }

  void move(Scenes& scenes) {
    before.clear();
    for (const MoverId id : scenes.front().movers()) {
      const Pose last = scenes.front().mover(id).pose;
      const std::uint64_t kind = rng_.below(6);
      if (kind == 0) {
        continue;
      }
      before[id] = last;
      Pose next = pose();
      if (kind == 1) {  // a short way, which turns a little or not
        next = rng_.below(2) == 0 ? Pose::about_z(0.2, {0, 0, 0}) * last : last;
        next.m[3] += rng_.uniform(-2, 2);
      }
      scenes.change([&](Scene& scene) { scene.set_pose(id, next); });
    }
  }

  void come_and_go(Scenes& scenes) {
    const std::vector<MoverId> movers = scenes.front().movers();
    const Body body(Shape(test::random_mesh(rng_)), pose());
    const std::uint64_t kind = rng_.below(4);
    if (movers.empty() || kind == 0) {
      scenes.change([&](Scene& scene) { scene.add_mover(body); });
      return;
    }
    const MoverId id = movers[rng_.below(movers.size())];
    if (kind == 3) {
      return;
    }
    before.erase(id);
    scenes.change([&](Scene& scene) {
      if (kind == 1) {
        scene.remove_mover(id);
      } else {
        scene.set_shape(id, body.shape);
      }
    });
  }

  std::map<MoverId, Pose> before;

 private:
  Rng& rng_;
  double reach_;
  Vec3 origin_;
};

TEST(SweptTwin, EqualsTheFirstContactOfEachPair) {
  std::map<ContactVerdict, std::size_t> verdicts;
  std::size_t free = 0;
  test::for_each_case("scene/swept", 60, [&](Rng& rng) {
    const Vec3 origin = rng.below(4) == 0 ? Vec3{5e5, 4.5e6, 100} : Vec3();
    Changes changes(rng, rng.uniform(4, 20), origin);
    Scenes scenes;
    changes.begin(scenes);
    for (int step = 0; step < 4; ++step) {
      const StepReport report = scenes.step();
      const test::Passages expected = test::passages(scenes.front(), changes.before);
      ASSERT_EQ(test::passages_of(report), expected);
      for (const EnvironmentPassage& passage : report.environment_passages) {
        ++verdicts[passage.verdict];
      }
      for (const MoverPassage& passage : report.mover_passages) {
        ++verdicts[passage.verdict];
      }
      free += report.passage_queries - report.environment_passages.size() -
              report.mover_passages.size();
      changes.move(scenes);
      changes.come_and_go(scenes);
    }
  });
  EXPECT_GT(verdicts[ContactVerdict::contact], 100U);
  EXPECT_GT(verdicts[ContactVerdict::started], 10U);
  EXPECT_GT(free, 100U);
}

// Here ways go down the tree of the knot as boxes first.
TEST(SweptTwin, EqualsTheFirstContactOfEachMoverWithALargeBody) {
  std::size_t passages = 0;
  std::size_t free = 0;
  test::for_each_case("scene/swept-large", 12, [&](Rng& rng) {
    const Layout layout = rng.below(3) == 0 ? Layout::compact : Layout::wide;
    const Shape knot(generate_knot(3000), {.layout = layout});
    const double away = rng.below(2) == 0 ? 0 : 1e6;
    const Shape chip(test::box_mesh({{-0.04, -0.02, -0.01}, {0.04, 0.02, 0.01}}));
    const auto pose = [&] {
      Pose turned = test::random_pose(rng, 0);
      turned.m[3] = away + rng.uniform(-3, 3);
      turned.m[7] = rng.uniform(-3, 3) - away;
      turned.m[11] = rng.uniform(-1, 1);
      return turned;
    };
    Pose place = test::random_pose(rng, 0);
    place.m[3] = away;
    place.m[7] = -away;
    Scenes scenes;
    scenes.change([&](Scene& scene) { scene.add_environment(Body(knot, place)); });
    std::map<MoverId, Pose> before;
    for (MoverId id = 0; id < 40; ++id) {
      before[id] = pose();
      scenes.change([&](Scene& scene) { scene.add_mover(Body(chip, before[id]), 1); });
    }
    static_cast<void>(scenes.step());
    for (MoverId id = 0; id < 40; ++id) {
      Pose next = pose();
      if (rng.below(2) == 0) {
        next = before[id];
        next.m[3] += rng.uniform(-0.3, 0.3);
      }
      scenes.change([&](Scene& scene) { scene.set_pose(id, next); });
    }
    const StepReport report = scenes.step();
    const auto no_movers = [](MoverId, MoverId) { return false; };
    ASSERT_EQ(test::passages_of(report),
              test::passages(scenes.front(), before, {.environment = {}, .movers = no_movers}));
    passages += report.environment_passages.size();
    free += report.passage_queries - report.environment_passages.size();
  });
  EXPECT_GT(passages, 50U);
  EXPECT_GT(free, 100U);
}

}  // namespace

}  // namespace soms
