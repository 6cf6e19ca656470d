// Scenes are made of what their descriptions say, and of other poses under another seed.
#include "soms/io/write_mesh.h"

#include "bench/peers/core/pair_counter.h"
#include "bench/peers/scenarios/catalog.h"
#include "bench/peers/scenarios/grazing.h"
#include "bench/peers/scenarios/solids.h"
#include "tests/support/support.h"

#include <set>

namespace soms::bench {
namespace {

TEST(FreeWay, EndsWhereTheBodyTouches) {
  const Search search{.step = 0.5, .reach = 10, .within = 1e-6};
  for (const double wall : {0.001, 0.5, 3.3, 9.99}) {
    const auto way = free_way([wall](double s) { return s >= wall; }, search);
    ASSERT_TRUE(way.has_value()) << wall;
    EXPECT_LT(*way, wall);
    EXPECT_GE(*way, wall - 1e-6);
  }
}

TEST(FreeWay, IsNoneWhereItTouchesAtOnceOrNowhere) {
  const Search search{.step = 0.5, .reach = 10};
  EXPECT_FALSE(free_way([](double) { return true; }, search).has_value());
  EXPECT_FALSE(free_way([](double s) { return s > 11; }, search).has_value());
}

TEST(Onward, ShiftsAlongTheLineAndKeepsTheRotation) {
  const Pose start = Pose::about_z(0.3, {1, 2, 3});
  const Pose pose = onward(start, {0, 0.6, 0.8}, 5);
  EXPECT_EQ(pose.shift(), (Vec3{1, 5, 7}));
  EXPECT_EQ(pose.m[0], start.m[0]);
  EXPECT_EQ(pose.m[5], start.m[5]);
}

// Recorded results are about these poses.
TEST(Seeds, ThatAreOneGiveThePosesOfRecordedResults) {
  Rng rng = rng_of(11, 1);
  EXPECT_EQ(rng.next(), Rng(11).next());
  EXPECT_NE(rng_of(11, 2).next(), Rng(11).next());
  EXPECT_NE(rng_of(11, 2).next(), rng_of(12, 2).next());
}

std::size_t touching(const Scene& scene, const PoseSet& set) {
  const PairCounter counter(scene.mover, scene.fixed);
  std::size_t count = 0;
  for (const Pose& pose : set.poses) {
    count += counter.count(pose, true) != 0 ? 1U : 0U;
  }
  return count;
}

/// Two models and a city, as files.
class ModelScenes : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name, const FloatMesh& mesh) {
    const auto path = folder_.path() / (name + ".ply");
    std::filesystem::create_directories(path.parent_path());
    write_mesh(path, widened(mesh), MeshFormat::ply);
    return path;
  }

  test::TemporaryFolder folder_;
};

TEST_F(ModelScenes, OfTwoModelsTouchAtSomeRandomPosesAndAtAllGrazingOnes) {
  const auto knot = file("knot", torus_knot(20, 6));
  const auto slab = file("slab", box({40, 0, 0}, {9, 3, 1}));
  std::set<double> places;
  for (const std::uint64_t seed : {1U, 2U}) {
    const Scene scene = unlike_models_scene("unlike", knot, slab, seed);
    ASSERT_EQ(scene.sets.size(), 2U);
    for (const PoseSet& set : scene.sets) {
      EXPECT_EQ(set.poses.size(), kPoses);
      EXPECT_EQ(set.jobs, kAnyAndAll);
      places.insert(set.poses.front().m[3]);
    }
    const std::size_t random = touching(scene, scene.sets[0]);
    EXPECT_GT(random, kPoses / 10);
    EXPECT_LT(random, kPoses * 9 / 10);
    EXPECT_EQ(touching(scene, scene.sets[1]), kPoses);
  }
  EXPECT_EQ(places.size(), 4U);
}

TEST_F(ModelScenes, OfAHallAreUprightAndInIt) {
  const auto chair = file("chair", box({0, 0, 45}, {20, 20, 45}));
  FloatMesh room = box({0, 0, 150}, {500, 300, 150});
  append(room, box({100, 50, 40}, {50, 200, 40}));
  const Scene scene = unlike_hall_scene("unlike", chair, file("room", room), 0.01, 1);
  EXPECT_EQ(touching(scene, scene.sets[1]), kPoses);
  for (const PoseSet& set : scene.sets) {
    for (const Pose& pose : set.poses) {
      EXPECT_EQ(pose.m[10], 1);
      EXPECT_LE(std::abs(pose.m[11]), 1.5);
    }
  }
}

TEST_F(ModelScenes, OfACityTakeTheMoverInMeters) {
  FloatMesh city{{{-60, -60, 0}, {60, -60, 0}, {60, 60, 0}, {-60, 60, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  for (int i = 0; i < 9; ++i) {
    append(city, box({40.0 * (i % 3) - 40, 40.0 * (i / 3) - 40, 5}, {8, 8, 5}));
  }
  const auto town = file("city", city);
  const auto jeep = file("jeep", box({0, 0, 3}, {4, 8, 3}));
  const Scene scene = unlike_city_scene("unlike", town, jeep, 0.25, 1);
  EXPECT_EQ(scene.mover.vertices.back()[1], 2);
  EXPECT_EQ(scene.sets[1].poses.size(), kPoses);
  EXPECT_EQ(touching(scene, scene.sets[1]), kPoses);
  const Scene other = unlike_city_scene("unlike", town, jeep, 0.25, 2);
  EXPECT_NE(scene.sets[0].poses.front(), other.sets[0].poses.front());
}

// The base stands clear of the cell, and some configurations do.
TEST(ArmScene, HasSixLinksThatTouchAtGrazingConfigurations) {
  const Scene scene = arm_scene(1);
  ASSERT_EQ(scene.links.size(), 6U);
  EXPECT_NEAR(static_cast<double>(scene.fixed.triangles.size()), 300'000, 3'000);
  std::vector<PairCounter> links;
  for (const FloatMesh& link : scene.links) {
    links.emplace_back(link, scene.fixed);
  }
  const auto touches = [&](const PoseSet& set, std::size_t i) {
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < 6; ++k) {
      count += links[k].count(set.poses[6 * i + k], true);
    }
    return count != 0;
  };
  std::size_t random = 0;
  for (std::size_t i = 0; i < 20; ++i) {
    random += touches(scene.sets[0], i) ? 1U : 0U;
    EXPECT_TRUE(touches(scene.sets[1], i)) << i;
    EXPECT_EQ(links[0].count(scene.sets[0].poses[6 * i], true), 0U);
  }
  EXPECT_GT(random, 2U);
  EXPECT_LT(random, 18U);
  for (const PoseSet& set : scene.sets) {
    EXPECT_EQ(set.poses.size(), 6 * kPoses);
  }
}

TEST(Catalog, OffersAnArmWithoutAnyFile) {
  const auto offers = catalog({}, 1);
  const auto arm = std::find_if(offers.begin(), offers.end(), [](const Offer& offer) {
    return offer.scene == "unlike-arm-cell";
  });
  EXPECT_NE(arm, offers.end());
  EXPECT_TRUE(std::none_of(offers.begin(), offers.end(), [](const Offer& offer) {
    return offer.scene.starts_with("unlike") && offer.scene != "unlike-arm-cell";
  }));
}

}  // namespace
}  // namespace soms::bench
