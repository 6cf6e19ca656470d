#include "apps/view/scene/load.h"

#include "soms/base/error.h"
#include "soms/io/write_mesh.h"
#include "soms/scene/recording.h"

#include "apps/view/scene/view_scene.h"
#include "apps/world/recorded_world.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <vector>

namespace soms::view {
namespace {

TEST(Load, MakesTheMotionsOfASimulation) {
  command::Shared shared;
  shared.quiet = true;
  command::Console console(shared);
  test::TemporaryFolder folder;
  const std::string city = (folder.path() / "city.ply").string();
  write_mesh(city, test::box_body({0, 0, 0}, {50, 50, 10}, 4), MeshFormat::ply);
  command::WorldOptions options;
  options.cities = {city};
  options.count = 5;
  const command::World world = command::load_world(options, console);
  ViewScene scene(content_of(world));
  EXPECT_EQ(scene.title(), "city");
  ASSERT_EQ(scene.movers(), world.routes.size());
  ASSERT_GT(scene.movers(), 0U);
  EXPECT_TRUE(scene.contacts().empty());  // movers start free
  scene.go_to(30);
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
    EXPECT_EQ(scene.body(mover(k)).pose, world.routes[k].at(30));
    EXPECT_EQ(scene.body(mover(k)).shape.shared_mesh(),
              world.models[world.routes[k].model].shape.shared_mesh());
  }
}

/// A block that drives at a wall and through it, recorded for `frames` frames.
struct Recorded {
  command::World world;
  std::string bytes;

  explicit Recorded(std::uint64_t frames) {
    world.title = "wall";
    world.city.emplace_back(test::box_body({3, -5, 0}, {4, 5, 5}));
    command::Model model;
    model.shape = Shape(test::box_body({0, 0, 0}, {1, 1, 1}));
    model.name = "block";
    world.models.push_back(std::move(model));
    world.routes.emplace_back();
    std::ostringstream out;
    RecordingHead head;
    head.title = "wall";
    head.environment.emplace_back();
    head.environment[0].mesh.triangles = world.city[0].shape.mesh().triangles.size();
    head.models.emplace_back();
    head.models[0].triangles = world.models[0].shape.mesh().triangles.size();
    head.movers = {0};
    RecordingWriter writer(out, head);
    Scene scene;
    scene.add_environment(world.city[0]);
    scene.add_mover(Body(world.models[0].shape));
    for (std::uint64_t k = 0; k < frames; ++k) {
      const std::vector<Pose> poses{Pose::translation(0.5 * static_cast<double>(k), 0, 1)};
      scene.set_pose(0, poses[0]);
      writer.add(poses, scene.step());
    }
    writer.finish(RecordingEnding::complete);
    bytes = out.str();
  }

  [[nodiscard]] ViewScene open(const std::string& with) const {
    return ViewScene(content_of(world, Replay(std::make_unique<std::istringstream>(with), "test")));
  }
};

TEST(Load, PlaysARecording) {
  const Recorded recorded(12);
  ViewScene scene = recorded.open(recorded.bytes);
  EXPECT_EQ(scene.frames(), 12U);
  std::size_t touching = 0;
  for (std::uint64_t k = 0; k < 12; ++k) {
    EXPECT_TRUE(scene.replaying());
    EXPECT_EQ(scene.body(mover(0)).pose, Pose::translation(0.5 * static_cast<double>(k), 0, 1));
    const Overlap requested = overlap(scene.body(mover(0)), scene.body(city_part(0)));
    ASSERT_EQ(scene.contacts().size(), requested.pairs.size());
    for (std::size_t n = 0; n < requested.pairs.size(); ++n) {
      EXPECT_EQ(scene.contacts()[n],
                (Touch{mover(0), city_part(0), requested.pairs[n].a, requested.pairs[n].b}));
    }
    touching += requested.any ? 1U : 0U;
    scene.step();
  }
  EXPECT_EQ(touching, 5U);
  EXPECT_EQ(scene.frame(), 0U);
  scene.go_to(7);
  EXPECT_EQ(scene.body(mover(0)).pose, Pose::translation(3.5, 0, 1));
}

TEST(Load, AsksAnewWhereTheHandMovesARecordedMover) {
  const Recorded recorded(12);
  ViewScene scene = recorded.open(recorded.bytes);
  scene.set_pose(0, Pose::translation(2.5, 1, 1));
  EXPECT_FALSE(scene.replaying());
  EXPECT_FALSE(scene.contacts().empty());
  scene.step();
  EXPECT_EQ(scene.body(mover(0)).pose, Pose::translation(2.5, 1, 1));
  scene.release(0);
  EXPECT_FALSE(scene.replaying());  // it still stands where the hand put it
  scene.step();
  EXPECT_TRUE(scene.replaying());
  EXPECT_EQ(scene.body(mover(0)).pose, Pose::translation(1, 0, 1));
}

TEST(Load, StaysAtItsFrameWhereTheRecordingWasCutSince) {
  const Recorded recorded(400);
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "drive.recording";
  std::ofstream(path, std::ios::binary) << recorded.bytes;
  ViewScene scene(content_of(recorded.world, Replay(path)));
  scene.go_to(2);
  std::filesystem::resize_file(path, recorded.bytes.size() / 4);
  EXPECT_THROW(scene.go_to(390), Error);
  EXPECT_EQ(scene.frame(), 2U);
  EXPECT_EQ(scene.body(mover(0)).pose, Pose::translation(1, 0, 1));
}

TEST(Load, PlaysWhatIsWholeOfADamagedRecording) {
  const Recorded recorded(100);
  std::string damaged = recorded.bytes;
  damaged.resize(damaged.size() - 40);
  ViewScene scene = recorded.open(damaged);
  ASSERT_TRUE(scene.frames().has_value());
  EXPECT_LE(*scene.frames(), 100U);
  EXPECT_GE(*scene.frames(), 64U);
  ASSERT_EQ(scene.notes().size(), 1U);
  EXPECT_NE(scene.notes()[0].find("frames can be read"), std::string::npos);
}

TEST(Load, LeavesOutMoversWhereNoFrameIsWhole) {
  const Recorded recorded(3);
  ViewScene scene = recorded.open(recorded.bytes.substr(0, recorded.bytes.size() - 150));
  EXPECT_EQ(scene.movers(), 0U);
  EXPECT_EQ(scene.city_parts(), 1U);
  EXPECT_FALSE(scene.frames().has_value());
  ASSERT_EQ(scene.notes().size(), 1U);
  EXPECT_NE(scene.notes()[0].find("only 0 frames"), std::string::npos);
}

TEST(Load, FindsTheModelsOfARecording) {
  command::Shared shared;
  shared.quiet = true;
  command::Console console(shared);
  test::TemporaryFolder folder;
  const std::string city = (folder.path() / "city.ply").string();
  write_mesh(city, test::box_body({0, 0, 0}, {50, 50, 10}, 4), MeshFormat::ply);
  command::WorldOptions options;
  options.cities = {city};
  options.count = 3;
  const command::World world = command::load_world(options, console);
  const auto path = folder.path() / "drive.recording";
  Scene scene = command::make_scene(world);
  {
    std::ofstream out(path, std::ios::binary);
    RecordingWriter writer(out, command::recording_head(world, 20));
    for (std::uint64_t frame = 0; frame < 20; ++frame) {
      std::vector<Pose> poses;
      for (std::uint32_t k = 0; k < world.routes.size(); ++k) {
        poses.push_back(world.routes[k].at(frame));
        scene.set_pose(k, poses.back());
      }
      writer.add(poses, scene.step());
    }
    writer.finish(RecordingEnding::complete);
  }
  ViewScene shown(load_recording(path, {}, console));
  EXPECT_TRUE(shown.replaying());
  EXPECT_EQ(shown.frames(), 20U);
  ASSERT_EQ(shown.movers(), world.routes.size());
  shown.go_to(13);
  for (std::uint32_t k = 0; k < shown.movers(); ++k) {
    EXPECT_EQ(shown.body(mover(k)).pose, world.routes[k].at(13));
  }
  EXPECT_TRUE(shown.notes().empty());
  EXPECT_THROW((void)load_recording(path, options, console), Error);
  EXPECT_THROW((void)load_recording(city, {}, console), Error);
}

TEST(Load, RefusesARecordingOfOtherBodies) {
  Recorded recorded(3);
  recorded.world.routes.emplace_back();
  EXPECT_THROW((void)recorded.open(recorded.bytes), Error);
}

TEST(Load, ReadsADroppedFile) {
  test::TemporaryFolder folder;
  const auto path = folder.path() / "block.stl";
  write_mesh(path, test::box_body({0, 0, 0}, {1, 2, 3}), MeshFormat::stl);
  const auto [body, notes] = read_body(path);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(body.name, "block");
  EXPECT_EQ(body.shape.bounds().upper, (Vec3{1, 2, 3}));
  EXPECT_THROW((void)read_body(folder.path() / "none.ply"), Error);
}

}  // namespace
}  // namespace soms::view
