// The verb time-frames: its JSON, the same contacts as a query, and what it refuses.
#include "apps/view/verbs/time_frames.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/io/write_mesh.h"
#include "soms/query/overlap.h"

#include "apps/view/drawing/gl/headless_context.h"
#include "tests/support/support.h"

#include <nlohmann/json.hpp>

#include <array>
#include <fstream>
#include <string>
#include <vector>

namespace soms::view {
namespace {

bool has_renderer() {
  try {
    const HeadlessContext context;
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// A ball, and poses on which another one is apart from it, touches it, and is in its middle.
class TimeFrames : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_renderer()) {
      GTEST_SKIP() << "nothing is drawn here without EGL, so this is untested";
    }
    ball_ = (folder_.path() / "ball.ply").string();
    poses_ = (folder_.path() / "poses.csv").string();
    write_mesh(ball_, generate_sphere(200), MeshFormat::ply);
    std::ofstream(poses_) << "x,y,z\n5,0,0\n1.2,0,0\n0.5,0.25,0\n";
  }

  [[nodiscard]] test::RunResult run(std::vector<std::string> words) const {
    words.insert(words.begin(),
                 {SOMS_VIEW_COMMAND, "time-frames", ball_, "--pose", poses_, "--passes", "1"});
    return test::run_program(words);
  }

  test::TemporaryFolder folder_;
  std::string ball_;
  std::string poses_;
};

TEST_F(TimeFrames, GiveTimesAndContactsOfEachFrameAsJson) {
  const Shape ball(generate_sphere(200));
  for (const char* const traversal : {"e-node", "larsson"}) {
    const test::RunResult result =
        run({"--mover", ball_, "--tree", std::string("traversal=") + traversal, "--mover-levels",
             "5", "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    const nlohmann::ordered_json answer = nlohmann::ordered_json::parse(result.out);
    EXPECT_EQ(answer.at("schema"), "soms.time-frames/1");
    EXPECT_FALSE(answer.at("device").get<std::string>().empty());
    EXPECT_EQ(answer.at("width"), 640);
    EXPECT_EQ(answer.at("height"), 480);
    EXPECT_EQ(answer.at("triangles"), 400);
    ASSERT_EQ(answer.at("frames").size(), 3U);
    const std::array<Vec3, 3> places{{{5, 0, 0}, {1.2, 0, 0}, {0.5, 0.25, 0}}};
    for (std::size_t k = 0; k < places.size(); ++k) {
      const nlohmann::ordered_json& frame = answer.at("frames").at(k);
      const Pose pose = Pose::translation(places[k].x, places[k].y, places[k].z);
      EXPECT_EQ(frame.at("contacts"), overlap(Body(ball), Body(ball, pose)).pairs.size());
      EXPECT_GT(frame.at("drawn").at("draw_ms").get<double>(), 0);
      for (const char* const pass : {"alone", "drawn"}) {
        EXPECT_GE(frame.at(pass).at("move_ms").get<double>(), 0);
        EXPECT_GT(frame.at(pass).at("query_ms").get<double>(), 0);
      }
    }
  }
}

TEST_F(TimeFrames, TellPeopleTheMeans) {
  const test::RunResult result = run({"--mover", ball_, "--size", "100x50"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out.find("3 frames, 100x50, drawn by "), 0U) << result.out;
  EXPECT_NE(result.out.find("\nwith drawing: collision "), std::string::npos) << result.out;
}

TEST_F(TimeFrames, RefuseWhatHasNoMeaningHere) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{},
                                                {"--mover", ball_, "--mover", ball_},
                                                {"--mover", ball_, "--count", "3"},
                                                {"--mover", ball_, "--tree", "traversal=fast"}}) {
    const test::RunResult result = run(words);
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_EQ(result.out, "");
  }
}

}  // namespace
}  // namespace soms::view
