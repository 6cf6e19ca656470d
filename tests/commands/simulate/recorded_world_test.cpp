#include "apps/world/recorded_world.h"

#include "soms/base/error.h"

#include "tests/commands/run.h"

#include <sys/stat.h>

#include <cstdlib>

namespace soms::command {
namespace {

class RecordedWorld : public ::testing::Test {
 protected:
  RecordedWorld() {
    EXPECT_EQ(
        test::soms_run({"generate", "city", "--triangles", "3000", "-o", path("town.ply")}).status,
        0);
    EXPECT_EQ(test::soms_run({"generate", "car", "-o", path("car.ply")}).status, 0);
    std::filesystem::create_directory(path("elsewhere"));
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  /// The head of a recording of cars in the town.
  [[nodiscard]] RecordingHead record(const std::vector<std::string>& movers) {
    WorldOptions options;
    options.cities = {path("town.ply")};
    options.movers = movers;
    options.count = 12;
    options.mover_model.scale = 0.5;
    const World world = load_world(options, console_);
    RecordingHead head = recording_head(world, 7);
    EXPECT_EQ(head.movers.size(), world.routes.size());
    return head;
  }

  [[nodiscard]] World load(const RecordingHead& head, const std::string& recording) {
    return load_recorded_world(head, path(recording), {}, console_);
  }

  /// Message of the error of a loading that must fail.
  [[nodiscard]] std::string fault(const RecordingHead& head, const std::string& recording) {
    try {
      (void)load(head, recording);
    } catch (const Error& error) {
      EXPECT_TRUE(error.kind() == ErrorKind::bad_file || error.kind() == ErrorKind::cannot_open);
      return error.what();
    }
    return "none";
  }

  Console console_{Shared{.quiet = true}};
  test::TemporaryFolder folder_;
};

TEST_F(RecordedWorld, ComesBackFromFilesAndGenerators) {
  for (const bool from_file : {true, false}) {
    const RecordingHead head =
        record(from_file ? std::vector{path("car.ply")} : std::vector<std::string>{});
    const World world = load(head, "run.somsrec");
    EXPECT_EQ(recording_head(world, 7), head);
    EXPECT_EQ(world.models.size(), from_file ? 1U : 3U);
    EXPECT_EQ(world.models[0].kind, from_file ? Kind::model : Kind::car);
    EXPECT_EQ(make_scene(world).movers().size(), head.movers.size());
  }
}

TEST_F(RecordedWorld, IsFoundBesideTheRecording) {
  const RecordingHead head = record({path("car.ply")});
  std::filesystem::rename(path("car.ply"), path("elsewhere/car.ply"));
  std::filesystem::rename(path("town.ply"), path("elsewhere/town.ply"));
  const std::string gone = fault(head, "run.somsrec");
  EXPECT_NE(gone.find(path("run.somsrec") + ", environment 0: the recorded model " +
                      path("town.ply") + " is neither at that path nor at " + path("town.ply")),
            std::string::npos)
      << gone;
  EXPECT_EQ(recording_head(load(head, "elsewhere/run.somsrec"), 7), head);
}

TEST_F(RecordedWorld, TellsAnAlteredModel) {
  const RecordingHead head = record({path("car.ply")});
  ASSERT_EQ(
      test::soms_run({"convert", path("car.ply"), path("car.ply"), "--scale", "1.001"}).status, 0);
  const std::string message = fault(head, "run.somsrec");
  EXPECT_NE(message.find("car.ply: not the model that was recorded"), std::string::npos) << message;
}

// A recording comes from anywhere: what it names must not read standard input, nor wait for ever.
TEST_F(RecordedWorld, ReadsOnlyFiles) {
  RecordingHead head = record({path("car.ply")});
  ASSERT_EQ(mkfifo(path("pipe.ply").c_str(), 0600), 0);
  for (const std::string& source : {std::string("-"), std::string(), path("pipe.ply")}) {
    head.models[0].source = source;
    EXPECT_NE(fault(head, "run.somsrec").find("\"" + source + "\", which is not a file"),
              std::string::npos)
        << source;
  }
}

TEST_F(RecordedWorld, MakesNoCityThatCannotBeTheOne) {
  RecordingHead head = record({});
  RecordedMesh& city = head.environment[0].mesh;
  city.origin = RecordedMesh::Origin::city;
  city.city_size = 4000;
  city.city_triangles = 4'000'000;
  EXPECT_NE(fault(head, "run.somsrec").find("made of 4,000,000"), std::string::npos);
  city.city_triangles = city.triangles = 5;
  EXPECT_NE(fault(head, "run.somsrec").find("an invalid city"), std::string::npos);
}

TEST_F(RecordedWorld, TellsAMoverOfNoKind) {
  RecordingHead head = record({});
  head.models[1].source = "tank";
  EXPECT_NE(fault(head, "run.somsrec").find("tank"), std::string::npos);
}

}  // namespace
}  // namespace soms::command
