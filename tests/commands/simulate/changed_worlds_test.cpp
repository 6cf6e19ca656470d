// Recordings that were changed by others, up to the bodies that `soms view` and `soms render` show:
// an error names the recording, or all of its frames can be shown.
#include "soms/base/error.h"
#include "soms/scene/replay.h"

#include "apps/world/recorded_world.h"
#include "tests/commands/run.h"
#include "tests/support/recording_mutations.h"
#include "tests/support/support.h"

#include <exception>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace soms::command {
namespace {

constexpr int kChangedWorlds = 5000;

/// What became of the changed recordings.
struct WorldOutcomes {
  int inputs = 0;
  int refused = 0;  ///< by the reader of recordings
  int others = 0;   ///< names models that are not there, or not the recorded ones
  int shown = 0;
};

/// A recording of two movers in a town of two triangles, in files.
class SmallRecording {
 public:
  SmallRecording() {
    test::write_text(file("town.obj"), "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 9 9 0\nf 1 2 3\nf 2 4 3\n");
    test::write_text(file("car.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 4\nf 1 3 2\n");
    WorldOptions options;
    options.cities = {file("town.obj")};
    options.movers = {file("car.obj")};
    options.count = 2;
    const World world = load_world(options, console_);
    std::ostringstream out;
    const RecordingHead head = recording_head(world, 3);
    RecordingWriter writer(out, head);
    Scene scene = make_scene(world);
    for (std::uint64_t frame = 0; frame < 3; ++frame) {
      std::vector<Pose> poses;
      for (MoverId k = 0; k < world.routes.size(); ++k) {
        poses.push_back(world.routes[k].at(frame));
        scene.set_pose(k, poses.back());
      }
      writer.add(poses, scene.step());
    }
    writer.finish(RecordingEnding::complete);
    bytes_ = out.str();
    const std::vector<test::RecordedChunk> chunks = test::chunks_of(bytes_);
    places_ = {test::numbers_of_head(chunks.at(0).content),
               test::numbers_of_frames(chunks.at(1).content, head.movers.size(), false, false),
               {{0, 1}, {1, 8}, {9, 8}, {17, 8}}};
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

  [[nodiscard]] std::string changed(Rng& rng) const {
    return test::changed_recording(bytes_, places_, rng);
  }

  /// Shows all frames, as the viewer does.
  void show(const std::string& bytes, WorldOutcomes& outcomes) const {
    ++outcomes.inputs;
    int* outcome = &outcomes.refused;
    try {
      Replay replay(std::make_unique<std::istringstream>(bytes), file("run.somsrec"));
      outcome = &outcomes.others;
      const World world = load_recorded_world(replay.head(), file("run.somsrec"), {}, console_);
      Scene scene = make_scene(world);
      for (std::uint64_t frame = 0; frame < replay.frames(); ++frame) {
        const RecordedFrame& shown = replay.frame(frame);
        for (MoverId k = 0; k < shown.poses.size(); ++k) {
          scene.set_pose(k, shown.poses[k]);
        }
      }
      outcome = &outcomes.shown;
    } catch (const Error& error) {
      EXPECT_NE(error.kind(), ErrorKind::usage) << error.what();
      EXPECT_TRUE(error.place().starts_with(file("run.somsrec") + ", ")) << error.what();
      EXPECT_FALSE(error.remedy().empty());
    } catch (const std::exception& error) {
      ADD_FAILURE() << "no typed error: " << error.what();
    }
    ++*outcome;
  }

 private:
  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  test::TemporaryFolder folder_;
  mutable Console console_{Shared{.quiet = true}};
  std::string bytes_;
  std::vector<test::NumberPlaces> places_;
};

TEST(ChangedWorlds, GiveErrorsThatNameTheRecordingOrAreShown) {
  const SmallRecording recording;
  WorldOutcomes outcomes;
  recording.show(recording.bytes(), outcomes);
  ASSERT_EQ(outcomes.shown, 1);
  outcomes = {};
  test::for_each_case("changed worlds", kChangedWorlds,
                      [&](Rng& rng) { recording.show(recording.changed(rng), outcomes); });
  EXPECT_GE(outcomes.inputs, kChangedWorlds);
  EXPECT_EQ(outcomes.inputs, outcomes.refused + outcomes.others + outcomes.shown);
  EXPECT_GT(outcomes.refused, kChangedWorlds / 50);
  EXPECT_GT(outcomes.others, kChangedWorlds / 50);
  EXPECT_GT(outcomes.shown, kChangedWorlds / 50);
}

}  // namespace
}  // namespace soms::command
