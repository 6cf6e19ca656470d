// `soms render` of a recording with gaps.
#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"
#include "soms/scene/recording.h"
#include "soms/scene/scene.h"

#include "apps/view/drawing/gl/headless_context.h"
#include "apps/view/drawing/picture_file.h"
#include "tests/support/support.h"
#include "tests/view/pictures.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace soms::view {
namespace {

/// The ball and two others, 3 and -3.5 along x, in a recording of one frame with a clearance; its
/// path.
std::string record_balls(const std::filesystem::path& folder, const std::string& ball,
                         double clearance) {
  RecordingHead head;
  head.clearance = clearance;
  head.environment.emplace_back();
  RecordedMesh& mesh = head.environment[0].mesh;
  mesh.name = "ball";
  mesh.source = ball;
  const Shape shape(read_mesh(ball));
  mesh.triangles = shape.mesh().triangles.size();
  mesh.hash = corner_hash(shape.mesh());
  head.models = {mesh};
  head.movers = {0, 0};
  Scene scene;
  scene.add_environment(Body(shape));
  const std::vector<Pose> poses{Pose::translation(3, 0, 0), Pose::translation(-3.5, 0, 0)};
  scene.add_mover(Body(shape, poses[0]));
  scene.add_mover(Body(shape, poses[1]));
  const std::filesystem::path path = folder / "balls.somsrec";
  std::ofstream out(path, std::ios::binary);
  RecordingWriter writer(out, head);
  writer.add(poses, scene.step({.clearance = clearance}));
  writer.finish(RecordingEnding::complete);
  return path.string();
}

TEST(RenderGaps, DrawsAndTellsTheGapsOfARecording) {
  try {
    const HeadlessContext context;
  } catch (const Error&) {
    GTEST_SKIP() << "nothing is drawn here without EGL, so this is untested";
  }
  const test::TemporaryFolder folder;
  const std::string ball = (folder.path() / "ball.ply").string();
  const std::string picture = (folder.path() / "out.png").string();
  write_mesh(ball, generate_sphere(800), MeshFormat::ply);  // of radius 1, about
  const auto rendered = [&](const std::string& recording, const char* more) {
    return test::run_program(
        {SOMS_VIEW_COMMAND, "render", recording, "-o", picture, "--size", "300x200", more});
  };
  const auto drawn = [&](double clearance) {
    const std::string recording = record_balls(folder.path(), ball, clearance);
    const test::RunResult result = rendered(recording, "--json");
    EXPECT_EQ(result.status, 0) << result.err;
    return std::pair(nlohmann::ordered_json::parse(result.out), read_png(picture));
  };
  const auto [without, plain] = drawn(0);
  EXPECT_FALSE(without.contains("gaps"));
  const auto [far, empty] = drawn(0.5);
  EXPECT_EQ(far["clearance"], 0.5);
  EXPECT_EQ(far["gaps"], 0);
  EXPECT_FALSE(far.contains("least_gap"));
  EXPECT_EQ(empty, plain);
  const auto [near, lined] = drawn(2);
  EXPECT_EQ(near["gaps"], 2);
  const nlohmann::ordered_json& gap = near["least_gap"];
  EXPECT_EQ(gap["city"], "ball");
  EXPECT_EQ(gap["mover"], 0);
  EXPECT_NEAR(gap["lower"].get<double>(), 1, 0.1);
  EXPECT_NEAR(gap["points"][0][0].get<double>(), 2, 0.1);
  EXPECT_NEAR(gap["points"][1][0].get<double>(), 1, 0.1);
  EXPECT_NE(lined, plain);
  const test::RunResult text = rendered((folder.path() / "balls.somsrec").string(), "--no-gap");
  EXPECT_EQ(read_png(picture), plain);
  EXPECT_NE(text.err.find(", 2 gaps of at most 2 m, the least "), std::string::npos) << text.err;
}

}  // namespace
}  // namespace soms::view
