#include "apps/view/verbs/render_scene.h"

#include "soms/base/error.h"
#include "soms/scene/replay.h"

#include "apps/view/scene/view_scene.h"
#include "tests/support/support.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace soms::view {
namespace {

/// A town and a car as files, and a recording of cars in it.
class RecordedTown : public ::testing::Test {
 protected:
  RecordedTown() {
    run({"generate", "city", "--triangles", "3000", "-o", path("town.ply")});
    run({"generate", "car", "-o", path("car.ply")});
    run({"simulate", path("town.ply"), "--mover", path("car.ply"), "--count", "60", "--frames",
         "90", "--record", path("run.somsrec")});
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  void run(std::vector<std::string> words) const {
    words.insert(words.begin(), soms::test::command().string());
    const soms::test::RunResult result = soms::test::run_program(words);
    EXPECT_EQ(result.status, 0) << result.err;
  }

  [[nodiscard]] SceneContent load(const command::WorldOptions& options,
                                  const std::string& pose = {}) {
    return load_content(options, pose, console_);
  }

  [[nodiscard]] ErrorKind kind_of_fault(const command::WorldOptions& options,
                                        const std::string& pose = {}) {
    try {
      (void)load(options, pose);
    } catch (const Error& error) {
      return error.kind();
    }
    return ErrorKind::cancelled;
  }

  command::Console console_{command::Shared{.quiet = true}};
  soms::test::TemporaryFolder folder_;
};

TEST_F(RecordedTown, IsPlayedWithTheContactsThatWereRecorded) {
  ViewScene scene(load({.cities = {path("run.somsrec")}}), {});
  EXPECT_EQ(scene.frames(), 90U);
  EXPECT_TRUE(scene.notes().empty());
  Replay replay(path("run.somsrec"));
  std::size_t contacts = 0;
  for (std::uint64_t frame = 0; frame < 90; ++frame) {
    scene.go_to(frame);
    const RecordedFrame& recorded = replay.frame(frame);
    ASSERT_EQ(scene.statistics().contacts, recorded.environment.size() + recorded.movers.size());
    contacts += recorded.environment.size();
  }
  EXPECT_GT(contacts, 0U);
}

TEST_F(RecordedTown, IsPlayedUpToWhereItWasCut) {
  std::filesystem::resize_file(path("run.somsrec"),
                               std::filesystem::file_size(path("run.somsrec")) - 200);
  const ViewScene scene(load({.cities = {path("run.somsrec")}}), {});
  EXPECT_EQ(scene.frames(), 64U);
  ASSERT_EQ(scene.notes().size(), 1U);
  EXPECT_NE(scene.notes()[0].find("cut off"), std::string::npos) << scene.notes()[0];
}

TEST_F(RecordedTown, TellsModelsThatAreNotThoseThatWereRecorded) {
  run({"convert", path("car.ply"), path("car.ply"), "--scale", "1.01"});
  EXPECT_EQ(kind_of_fault({.cities = {path("run.somsrec")}}), ErrorKind::bad_file);
  std::filesystem::remove(path("car.ply"));
  EXPECT_EQ(kind_of_fault({.cities = {path("run.somsrec")}}), ErrorKind::cannot_open);
}

TEST_F(RecordedTown, IsDrawnByTheCommandAfterASimulation) {
  const auto draw = [&](const std::string& picture) {
    return soms::test::run_program({soms::test::command().string(), "simulate", path("town.ply"),
                                    "--mover", path("car.ply"), "--count", "5", "--frames", "9",
                                    "-o", picture});
  };
  const soms::test::RunResult result = draw(path("last.png"));
  if (result.status == 5) {
    GTEST_SKIP() << "nothing is drawn here without EGL: " << result.err;
  }
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("picture "), std::string::npos) << result.out;
  std::ifstream in(path("last.png"), std::ios::binary);
  std::string begin(4, ' ');
  in.read(begin.data(), 4);
  EXPECT_EQ(begin, "\x89PNG");
  EXPECT_EQ(draw(path("none/last.png")).status, 5);
}

TEST_F(RecordedTown, ACityHasOneOfEachModelUnlessACountIsGiven) {
  const std::vector<std::string> cities{path("town.ply")};
  const std::string car = path("car.ply");
  EXPECT_EQ(load({.cities = cities, .movers = {car}}).movers.size(), 1U);
  EXPECT_EQ(load({.cities = cities, .movers = {car, car}}).movers.size(), 2U);
  EXPECT_EQ(load({.cities = cities, .movers = {car}, .count = 7}).movers.size(), 7U);
  EXPECT_EQ(load({.cities = cities, .movers = {car}, .count = 1}).movers.size(), 1U);
  EXPECT_EQ(load({.cities = cities}).movers.size(), 0U);
}

TEST_F(RecordedTown, TakesNoOtherCityOrMover) {
  const std::string recording = path("run.somsrec");
  EXPECT_EQ(kind_of_fault({.cities = {recording}, .movers = {path("car.ply")}}), ErrorKind::usage);
  EXPECT_EQ(kind_of_fault({.cities = {recording}, .count = 3}), ErrorKind::usage);
  EXPECT_EQ(kind_of_fault({.cities = {recording}}, "0 0 0"), ErrorKind::usage);
}

}  // namespace
}  // namespace soms::view
