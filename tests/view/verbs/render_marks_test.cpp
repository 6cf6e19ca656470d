// Markers, key, ground and shadows of `soms render`.
#include "apps/view/drawing/palette.h"
#include "tests/view/pictures.h"
#include "tests/view/verbs/render_support.h"

#include <nlohmann/json.hpp>

#include <array>
#include <fstream>
#include <string>
#include <vector>

namespace soms::view {
namespace {

using test_render::count_red;
using test_render::render;

using RenderMarks = test_render::BallFolder;

TEST_F(RenderMarks, NumbersTouchingMoversThatAreSmallInThePicture) {
  SOMS_NEEDS_EGL();
  const auto red = [&](std::vector<std::string> words) {
    // From 4 km, where a triangle of the ball is smaller than a pixel.
    words.insert(words.begin(), {ball_, "--mover", ball_, "--pose", "1.2 0 0", "-o", picture_,
                                 "--size", "300x200", "--camera", "0 -4000 0 0 0 0"});
    const test::RunResult result = render(words);
    EXPECT_EQ(result.status, 0) << result.err;
    return count_red(read_png(picture_));
  };
  EXPECT_GT(red({}), 100U);
  EXPECT_GT(red({"--no-key"}), red({"--no-key", "--no-markers"}) + 100);
}

TEST_F(RenderMarks, MarkersSumUpToTheTouchingMovers) {
  SOMS_NEEDS_EGL();
  const std::string poses = (folder_.path() / "poses.csv").string();
  std::ofstream(poses) << "x,y,z,qw,qx,qy,qz\n1.2,0,0,1,0,0,0\n-1.2,0,0,1,0,0,0\n400,0,0,1,0,0,0\n"
                          "400.5,0,0,1,0,0,0\n0,900,0,1,0,0,0\n";
  const auto counts = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {ball_, "--mover", ball_, "--pose", poses, "-o", picture_, "--size",
                                 "320x180", "--json", "--no-shadow"});
    const test::RunResult result = render(words);
    EXPECT_EQ(result.status, 0) << result.err;
    const nlohmann::ordered_json json = nlohmann::ordered_json::parse(result.out);
    return std::array<int, 3>{json.at("touching_movers"), json.at("marked_movers"),
                              json.at("markers")};
  };
  EXPECT_EQ(counts({"--camera", "200 -2500 1500 200 0 0"}), (std::array{4, 4, 2}));
  EXPECT_EQ(counts({"--camera", "0 -8 3 0 0 0"}), (std::array{4, 0, 0})) << "large enough to see";
  EXPECT_EQ(counts({"--camera", "0 -8 3 0 0 0", "--spots"}), (std::array{4, 2, 2}));
}

TEST_F(RenderMarks, GroundShadowKeyAndTitleAreDrawnUnlessTheyAreTurnedOff) {
  SOMS_NEEDS_EGL();
  const auto picture = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {ball_, "-o", picture_, "--size", "320x180"});
    const test::RunResult result = render(words);
    EXPECT_EQ(result.status, 0) << result.err;
    return read_png(picture_);
  };
  const std::vector<std::string> off{"--no-key", "--no-ground", "--no-shadow"};
  const Picture bare = picture(off);
  for (std::size_t k = 0; k < off.size(); ++k) {
    std::vector<std::string> words = off;
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(k));
    // A shadow needs a ground to fall on.
    if (off[k] == "--no-shadow") {
      words = {"--no-key"};
      const Picture lit = picture({"--no-key", "--no-shadow"});
      EXPECT_GT(difference(lit, picture(words), 8).beyond, 200U) << off[k];
      continue;
    }
    EXPECT_GT(difference(bare, picture(words), 8).beyond, 200U) << off[k];
  }
  EXPECT_GT(count_near(picture({"--no-key", "--title", "Ball 1"}), palette::kInk, 30), 60U);
}

}  // namespace
}  // namespace soms::view
