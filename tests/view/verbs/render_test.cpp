#include "apps/view/verbs/render.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"
#include "soms/query/distance.h"
#include "soms/scene/recording.h"
#include "soms/scene/replay.h"
#include "soms/tree/build.h"
#include "soms/tree/statistics.h"

#include "apps/cli/text.h"
#include "apps/view/drawing/palette.h"
#include "apps/view/drawing/picture_file.h"
#include "tests/support/support.h"
#include "tests/view/pictures.h"
#include "tests/view/verbs/render_support.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace soms::view {
namespace {

using test_render::count_red;
using test_render::render;

using Render = test_render::BallFolder;

std::size_t files_in(const std::filesystem::path& folder) {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) {
    ++count;
  }
  return count;
}

TEST_F(Render, WritesAPictureOfTheSizeRequestedFor) {
  SOMS_NEEDS_EGL();
  const test::RunResult result = render({ball_, "-o", picture_, "--size", "200x100"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("200x100, 800 triangles, 0 touching pairs"), std::string::npos)
      << result.err;
  const Picture picture = read_png(picture_);
  EXPECT_EQ(picture.size, (Size{200, 100}));
  EXPECT_GT(picture.at(100, 50).r, picture.at(100, 50).b) << "the ball in the middle";
  EXPECT_LT(picture.at(5, 5).r, picture.at(5, 5).b) << "the sky beside it";
}

TEST_F(Render, ShowsRedWhereBodiesTouchAndNoneWhereTheyDoNot) {
  SOMS_NEEDS_EGL();
  const auto red = [&](const char* pose) {
    const test::RunResult result = render(
        {ball_, "--mover", ball_, "--pose", pose, "-o", picture_, "--size", "300x200", "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    const bool touches = result.out.find("\"touching_pairs\":0,") == std::string::npos;
    return std::pair(touches, count_red(read_png(picture_)));
  };
  const auto [apart_touches, apart] = red("5 0 0");
  EXPECT_FALSE(apart_touches);
  EXPECT_EQ(apart, 0U);
  const auto [touches, touching] = red("1.2 0 0");
  EXPECT_TRUE(touches);
  EXPECT_GT(touching, 50U);
}

TEST_F(Render, DrawsTheGapOfTwoModelsAlikeEachTimeUnlessItIsTurnedOff) {
  SOMS_NEEDS_EGL();
  const auto picture = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"-o", picture_, "--size", "300x200", "--json", "--no-key"});
    const test::RunResult result = render(words);
    EXPECT_EQ(result.status, 0) << result.err;
    const bool reported = result.out.find("\"gap\":{\"lower\":") != std::string::npos;
    return std::pair(read_png(picture_), reported);
  };
  const auto ink = [](const Picture& p) { return count_near(p, palette::kGap, 12); };
  const auto [drawn, reported] = picture({ball_, "--mover", ball_, "--pose", "4 0 0"});
  EXPECT_TRUE(reported);
  EXPECT_GT(ink(drawn), 150U);
  EXPECT_EQ(drawn.bytes, picture({ball_, "--mover", ball_, "--pose", "4 0 0"}).first.bytes);
  const auto [off, off_reported] =
      picture({ball_, "--mover", ball_, "--pose", "4 0 0", "--no-gap"});
  EXPECT_FALSE(off_reported);
  EXPECT_EQ(ink(off), 0U);
  const auto [touching, touching_reported] = picture({ball_, "--mover", ball_, "--pose", "1 0 0"});
  EXPECT_FALSE(touching_reported);
  EXPECT_EQ(ink(touching), 0U);
}

TEST_F(Render, ReportsTheGapThatTheLibraryFinds) {
  SOMS_NEEDS_EGL();
  const std::string other = (folder_.path() / "other.ply").string();
  Mesh shifted = read_mesh(ball_);
  for (Vec3& v : shifted.vertices) {
    v = v + Vec3{3, 1, 0.5};
  }
  write_mesh(other, shifted, MeshFormat::ply);
  const Distance near = distance(Body(read_mesh(ball_)), Body(read_mesh(other)));
  // As two models that stand still, and as one that is placed.
  for (const std::vector<std::string>& models :
       {std::vector<std::string>{ball_, other},
        std::vector<std::string>{ball_, "--mover", other, "--pose", "0 0 0"}}) {
    std::vector<std::string> words = models;
    words.insert(words.end(), {"-o", picture_, "--size", "90x60", "--json"});
    const test::RunResult result = render(words);
    ASSERT_EQ(result.status, 0) << result.err;
    const nlohmann::ordered_json gap = nlohmann::ordered_json::parse(result.out).at("gap");
    EXPECT_EQ(gap.at("lower"), near.distance.lower);
    EXPECT_EQ(gap.at("upper"), near.distance.upper);
    EXPECT_EQ(gap.at("triangles"),
              nlohmann::ordered_json::array({near.triangles->a, near.triangles->b}));
    EXPECT_EQ(gap.at("points").at(0),
              nlohmann::ordered_json::array({near.point_a.x, near.point_a.y, near.point_a.z}));
    EXPECT_EQ(gap.at("points").at(1),
              nlohmann::ordered_json::array({near.point_b.x, near.point_b.y, near.point_b.z}));
  }
  const test::RunResult beside =
      render({ball_, other, "--camera", "gap", "-o", picture_, "--size", "90x60"});
  EXPECT_EQ(beside.status, 0) << beside.err;
  EXPECT_NE(beside.err.find(", gap " + command::four_digits(near.distance.lower)),
            std::string::npos)
      << beside.err;
  const test::RunResult none =
      render({ball_, other, "--camera", "gap", "--no-gap", "-o", picture_, "--size", "90x60"});
  EXPECT_EQ(none.status, 2) << none.err;
}

TEST_F(Render, DrawsOneMoverForEachPoseOfAFile) {
  SOMS_NEEDS_EGL();
  const std::string poses = (folder_.path() / "poses.csv").string();
  std::ofstream(poses) << "x,y,z,qw,qx,qy,qz\n5,0,0,1,0,0,0\n-5,0,0,1,0,0,0\n1.2,0,0,1,0,0,0\n";
  const test::RunResult result = render(
      {ball_, "--mover", ball_, "--pose", poses, "-o", picture_, "--size", "90x60", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("\"movers\":3"), std::string::npos) << result.out;
}

TEST_F(Render, DrawsTheTreeByLevelAndTheBoxesOfATraversal) {
  SOMS_NEEDS_EGL();
  const auto boxes = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {ball_, "-o", picture_, "--size", "90x60", "--json"});
    const test::RunResult result = render(words);
    EXPECT_EQ(result.status, 0) << result.err;
    const std::size_t at = result.out.find("\"boxes\":");
    return at == std::string::npos ? -1 : std::stoi(result.out.substr(at + 8));
  };
  EXPECT_EQ(boxes({}), 0);
  EXPECT_EQ(boxes({"--level", "1"}), 1);
  EXPECT_EQ(boxes({"--level", "4"}), 8);
  EXPECT_EQ(boxes({"--level", "4", "--boxes", "both"}), 8);
  const int pruned = boxes({"--mover", ball_, "--pose", "1 0 0", "--trace"});
  EXPECT_GT(pruned, 10);
  EXPECT_GT(boxes({"--mover", ball_, "--pose", "1 0 0", "--trace", "--no-prune"}), pruned);
}

TEST_F(Render, CountsTheLevelAndTheLeavesAboveIt) {
  SOMS_NEEDS_EGL();
  const Mesh mesh = read_mesh(ball_);
  const Tree tree = build(mesh, {.rule = Rule::soms, .per_leaf = 1});
  const TreeStatistics counts = statistics(tree, {.rule = Rule::soms, .per_leaf = 1});
  const int level = static_cast<int>(counts.depth) + 1;
  const auto last = static_cast<std::uint64_t>(
      std::count_if(tree.nodes.begin(), tree.nodes.end(),
                    [&](const Node& node) { return node.depth == counts.depth; }));
  ASSERT_LT(last, counts.leaves) << "a ball whose leaves are on several levels";
  const test::RunResult result = render({ball_, "-o", picture_, "--size", "90x60", "--json",
                                         "--tree", "leaf=1", "--level", std::to_string(level)});
  EXPECT_NE(result.out.find("\"boxes\":" + std::to_string(counts.leaves) + ","), std::string::npos);
  EXPECT_NE(result.out.find("\"level_boxes\":" + std::to_string(last) +
                            ",\"leaves_above\":" + std::to_string(counts.leaves - last)),
            std::string::npos)
      << result.out;
  const test::RunResult below = render({ball_, "-o", picture_, "--level", "99"});
  EXPECT_NE(below.err.find(", or --tree leaf below 8"), std::string::npos) << below.err;
  const test::RunResult single =
      render({ball_, "-o", picture_, "--level", "99", "--tree", "leaf=1"});
  EXPECT_EQ(single.err.find("leaf below"), std::string::npos) << single.err;
}

TEST_F(Render, ANamedTraversalHasItsOwnDescent) {
  SOMS_NEEDS_EGL();
  const auto drawn = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {ball_, "--mover", ball_, "--pose", "1.2 0 0", "-o", picture_,
                                 "--size", "90x60", "--json", "--trace", "--tree", "leaf=1"});
    const test::RunResult result = render(words);
    EXPECT_EQ(result.status, 0) << result.err;
    const std::size_t at = result.out.find("\"boxes\":");
    return at == std::string::npos ? std::string() : result.out.substr(at, 16);
  };
  const std::string both = drawn({"--tree", "traversal=e-node", "--tree", "descent=both"});
  const std::string larger = drawn({"--tree", "traversal=e-node", "--tree", "descent=larger"});
  ASSERT_NE(both, larger);
  EXPECT_EQ(drawn({}), larger);
  EXPECT_EQ(drawn({"--tree", "traversal=e-node"}), both);
}

TEST_F(Render, SaysThatTreesAreThoseOfTheFirstFileOfACity) {
  SOMS_NEEDS_EGL();
  const std::string other = (folder_.path() / "other.ply").string();
  write_mesh(other, generate_sphere(200), MeshFormat::ply);
  const test::RunResult result =
      render({ball_, other, "--level", "3", "-o", picture_, "--size", "90x60"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("--level: of the city's 2 files with the first alone, ball"),
            std::string::npos)
      << result.err;
  const test::RunResult one = render({ball_, "--level", "3", "-o", picture_, "--size", "90x60"});
  EXPECT_EQ(one.err.find("--level"), std::string::npos) << one.err;
}

TEST_F(Render, TraversesWithTheOneMoverThatIsNamed) {
  SOMS_NEEDS_EGL();
  const test::RunResult result =
      render({ball_, "--mover", ball_, "--trace", "-o", picture_, "--size", "90x60", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("\"movers\":1,"), std::string::npos) << result.out;
}

TEST_F(Render, DrawsTheTreesOfTheThesisByName) {
  SOMS_NEEDS_EGL();
  const auto drawn = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{ball_, "--mover", ball_,    "--pose", "1 0 0", "--trace",
                                   "-o",  picture_,  "--size", "90x60",  "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const test::RunResult result = render(words);
    EXPECT_EQ(result.status, 0) << result.err;
    return result.out;
  };
  const std::string thesis = drawn({"--thesis"});
  EXPECT_EQ(thesis, drawn({"--tree", "rule=soms", "--tree", "midpoint=thesis", "--tree", "leaf=1",
                           "--tree", "empty-side=stop", "--tree", "levels=15", "--tree",
                           "traversal=e-node", "--tree", "descent=both"}));
  EXPECT_NE(thesis, drawn({}));
  EXPECT_NE(thesis, drawn({"--thesis", "--tree", "leaf=8"}));  // what is named, too, wins
}

TEST_F(Render, R119OptionsThatThePictureIgnoresAreRefused) {
  SOMS_NEEDS_EGL();

  struct Case {
    std::vector<std::string> words;
    std::string says;
  };

  const std::vector<Case> cases{
      {{"--tree", "rule=sah"}, "--tree rule has no effect without --level or --trace"},
      {{"--thesis"}, "--thesis has no effect without --level or --trace"},
      {{"--tree", "leaf=4"}, "--tree leaf has no effect without --level or --trace"},
      {{"--tree", "traversal=larger"}, "--tree traversal has no effect without --trace"},
      {{"--level", "2", "--tree", "descent=both"}, "--tree descent has no effect without --trace"},
      {{"--level", "2", "--tree", "rule=fast", "--tree", "midpoint=centroid"},
       "--tree midpoint has no effect"},
      {{"--level", "2", "--tree", "c-vertex=1"},
       "--tree c-vertex has no effect: only the midpoint thesis"},
      {{"--mover", ball_, "--trace", "--tree", "traversal=larger", "--tree", "descent=both"},
       "--tree descent has no effect: only E-Node has a descent"},
      {{"--mover", ball_, "--trace", "--tree", "traversal=e-node-front", "--no-prune"},
       "--no-prune: --tree traversal=e-node-front needs pruning"},
      {{"--mover", ball_, "--pose", "3 0 0", "--frame", "7"},
       "--frame 7 has no effect: --pose draws the mover at every pose, in one picture; leave it "
       "out, or give the poses as --route"},
      {{"--frame", "7"}, "--frame 7 has no effect: nothing moves here; leave it out"},
  };
  for (const Case& c : cases) {
    std::vector<std::string> words{ball_, "-o", picture_, "--size", "90x60"};
    words.insert(words.end(), c.words.begin(), c.words.end());
    const test::RunResult result = render(words);
    EXPECT_EQ(result.status, 2) << c.says;
    EXPECT_NE(result.err.find(c.says), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(picture_));
  }
  // A traversal other than E-Node does not trip over E-Node's descent, which nobody gave.
  EXPECT_EQ(render({ball_, "-o", picture_, "--size", "90x60", "--mover", ball_, "--trace", "--tree",
                    "traversal=larger"})
                .status,
            0);
}

TEST_F(Render, NamesFewerSamplesWhereADriverHasNoRoomForSoMany) {
  SOMS_NEEDS_EGL();
  const test::RunResult result =
      render({ball_, "-o", picture_, "--size", "16384x16384", "--samples", "16"});
  EXPECT_EQ(result.status, 5) << result.err;
  EXPECT_NE(result.err.find("use one sample (--samples 1), or a smaller --size"), std::string::npos)
      << result.err;
  EXPECT_FALSE(std::filesystem::exists(picture_));
}

TEST_F(Render, DrawsAFrameOfAnOrientationTest) {
  SOMS_NEEDS_EGL();
  const auto contacts = [&](const char* frame) {
    const test::RunResult result = render({ball_, "-o", picture_, "--size", "90x60", "--json",
                                           "--mover", ball_, "--test", "drive", "--frame", frame});
    EXPECT_EQ(result.status, 0) << result.err;
    const std::size_t at = result.out.find("\"touching_pairs\":");
    return at == std::string::npos ? -1 : std::stoi(result.out.substr(at + 17));
  };
  EXPECT_EQ(contacts("0"), 0);
  EXPECT_GT(contacts("100"), 0);
}

TEST_F(Render, DrawsTheFrameOfATestInWhichMostTouchesUnlessOneIsChosen) {
  SOMS_NEEDS_EGL();
  const auto drawn = [&](std::vector<std::string> more) {
    more.insert(more.end(), {ball_, "--mover", ball_, "-o", picture_, "--size", "90x60", "--json"});
    const test::RunResult result = render(more);
    EXPECT_EQ(result.status, 0) << result.err;
    return nlohmann::ordered_json::parse(result.out);
  };
  const nlohmann::ordered_json last = drawn({"--test", "right"});
  EXPECT_EQ(last.at("frame"), 48);
  EXPECT_EQ(last.at("test"), "right");
  EXPECT_GT(last.at("touching_pairs"), 0);
  EXPECT_EQ(drawn({"--test", "drive"}).at("frame"), 110);
  EXPECT_EQ(drawn({"--test", "right", "--frame", "0"}).at("touching_pairs"), 0);
  const test::RunResult said =
      render({ball_, "--mover", ball_, "-o", picture_, "--size", "90x60", "--test", "top"});
  EXPECT_NE(said.err.find("frame 48 of 0 to 48 of the test top"), std::string::npos) << said.err;
}

TEST_F(Render, ATestStandsModelsUprightThatLookSo) {
  SOMS_NEEDS_EGL();
  // A cone whose tip is at +y: upright it is met in the frame that meets its base first.
  const std::string cone = (folder_.path() / "cone.ply").string();
  std::ofstream file(cone);
  constexpr int kCorners = 24;
  file << "ply\nformat ascii 1.0\nelement vertex " << kCorners + 2
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << 2 * kCorners
       << "\nproperty list uchar int vertex_indices\nend_header\n0 3 0\n0 0 0\n";
  for (int k = 0; k < kCorners; ++k) {
    file << std::cos(k * 2 * std::numbers::pi / kCorners) << " 0 "
         << std::sin(k * 2 * std::numbers::pi / kCorners) << '\n';
  }
  for (int k = 0; k < kCorners; ++k) {
    const int next = (k + 1) % kCorners;
    file << "3 0 " << 2 + next << ' ' << 2 + k << "\n3 1 " << 2 + k << ' ' << 2 + next << '\n';
  }
  file.close();
  const test::RunResult result =
      render({cone, "--mover", cone, "-o", picture_, "--size", "90x60", "--test", "top"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("looks y up, and is drawn so"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("--mover-up z keeps it"), std::string::npos) << result.err;
}

TEST_F(Render, DrawsBoxesThatCollideInRedAndSurfacesThatTouchInViolet) {
  SOMS_NEEDS_EGL();
  const auto drawn = [&](std::vector<std::string> more) {
    more.insert(more.end(), {ball_, "--mover", ball_, "--pose", "1.2 0 0", "-o", picture_, "--size",
                             "300x200", "--no-key"});
    const test::RunResult result = render(more);
    EXPECT_EQ(result.status, 0) << result.err;
    const Picture picture = read_png(picture_);
    return std::pair(count_red(picture), count_near(picture, palette::kViolet, 60));
  };
  const auto [red, violet] = drawn({});
  EXPECT_GT(red, 50U);
  EXPECT_EQ(violet, 0U);
  const auto [box_red, touch_violet] = drawn({"--trace"});
  EXPECT_GT(box_red, 50U);
  EXPECT_GT(touch_violet, 50U);
}

TEST_F(Render, NotesAndWarningsAreInJson) {
  SOMS_NEEDS_EGL();
  const std::string lossy = (folder_.path() / "lossy.obj").string();
  std::ofstream(lossy) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nF 3 2 1\n";
  const std::string other = (folder_.path() / "ball.glb").string();
  Mesh ball = generate_sphere(200);
  ball.unit = 1;
  ball.up = UpAxis::z;
  write_mesh(other, ball, MeshFormat::glb);
  const test::RunResult result = render(
      {lossy, "--mover", other, "--pose", "0 0 0", "-o", picture_, "--size", "90x60", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("\"notes\":[\"" + lossy + ": lines that start with"), std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("\"warnings\":[{\"kind\":\"axis_unknown\""), std::string::npos)
      << result.out;
  const test::RunResult clean = render({ball_, "-o", picture_, "--size", "90x60", "--json"});
  EXPECT_EQ(clean.out.find("\"notes\""), std::string::npos) << clean.out;
  EXPECT_EQ(clean.out.find("\"warnings\""), std::string::npos) << clean.out;
}

TEST_F(Render, WritesToStandardOutput) {
  SOMS_NEEDS_EGL();
  const test::RunResult result = render({ball_, "-o", "-", "--size", "20x10", "--quiet"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(from_png(result.out).size, (Size{20, 10}));
}

TEST_F(Render, TellsFaultsInOneSentenceAndLeavesNoFile) {
  SOMS_NEEDS_EGL();
  const std::string empty = (folder_.path() / "empty.ply").string();
  std::ofstream(empty) << "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\n"
                          "property float y\nproperty float z\nelement face 0\n"
                          "property list uchar int vertex_indices\nend_header\n";

  struct Case {
    std::vector<std::string> words;
    int status;
  };

  const std::vector<Case> cases{
      {{"nothing.ply", "-o", picture_}, 3},
      {{empty, "-o", picture_}, 3},
      {{ball_}, 2},
      {{ball_, "-o", picture_, "--size", "0x5"}, 2},
      {{ball_, "-o", picture_, "--size", "99999x5"}, 2},
      {{ball_, "-o", picture_, "--camera", "nowhere"}, 2},
      {{ball_, "-o", picture_, "--camera", "contact"}, 2},
      {{ball_, "-o", picture_, "--trace"}, 2},
      {{ball_, "-o", picture_, "--test", "top"}, 2},
      {{ball_, "-o", picture_, "--mover", ball_, "--test", "sideways"}, 2},
      {{ball_, "-o", picture_, "--mover", ball_, "--test", "top", "--frame", "99999"}, 2},
      {{ball_, "-o", picture_, "--pose", "1 0 0"}, 2},
      {{ball_, "-o", picture_, "--level", "0"}, 2},
      {{ball_, "-o", picture_, "--level", "99"}, 2},
      {{ball_, "-o", picture_, "--boxes", "both"}, 2},
      {{ball_, "-o", picture_, "--level-of", "mover"}, 2},
      {{ball_, "-o", picture_, "--no-prune"}, 2},
      {{ball_, "-o", picture_, "--center"}, 2},
      {{ball_, "-o", picture_, "--mover", ball_, "--trace", "--tree", "traversal=fast"}, 2},
      {{ball_, "-o", (folder_.path() / "out.jpg").string()}, 2},
      {{ball_, "-o", picture_, "--timeout", "0"}, 4},
      {{ball_, "-o", (folder_.path() / "missing" / "out.png").string()}, 5},
  };
  for (const Case& c : cases) {
    const test::RunResult result = render(c.words);
    EXPECT_EQ(result.status, c.status) << result.err;
    EXPECT_EQ(result.err.rfind("soms-view render: ", 0), 0U) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
    EXPECT_TRUE(result.out.empty());
  }
  EXPECT_EQ(files_in(folder_.path()), 2U) << "the two models alone";
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // both reserve terabytes
TEST_F(Render, EndsWhereMemoryIsNotEnough) {
  SOMS_NEEDS_EGL();
  const test::RunResult result = render({ball_, "-o", picture_, "--max-memory", "50M"});
  EXPECT_EQ(result.status, 4) << result.err;
  EXPECT_EQ(result.err.rfind("soms-view render: ", 0), 0U) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  EXPECT_EQ(files_in(folder_.path()), 1U) << "the model alone";
}
#endif

TEST_F(Render, DrawsFramesThatARecordingHasAndRefusesOthers) {
  SOMS_NEEDS_EGL();
  RecordingHead head;
  head.environment.emplace_back();
  RecordedMesh& ball = head.environment[0].mesh;
  ball.source = ball_;
  ball.file_size = std::filesystem::file_size(ball_);
  const Mesh mesh = read_mesh(ball_);
  ball.triangles = mesh.triangles.size();
  ball.hash = corner_hash(mesh);
  const std::string recording = (folder_.path() / "run.somsrec").string();
  {
    std::ofstream out(recording, std::ios::binary);
    RecordingWriter writer(out, head);
    writer.add({}, {});
    writer.add({}, {});
    writer.finish(RecordingEnding::complete);
  }
  EXPECT_EQ(render({recording, "-o", picture_, "--frame", "1"}).status, 0);
  std::filesystem::remove(picture_);
  const test::RunResult behind = render({recording, "-o", picture_, "--frame", "2"});
  EXPECT_EQ(behind.status, 2);
  EXPECT_NE(behind.err.find("there are frames from 0 to 1 only"), std::string::npos) << behind.err;
  EXPECT_FALSE(std::filesystem::exists(picture_));
}

TEST_F(Render, SaysWhatIsMissingWhereNothingCanBeDrawn) {
  // The dispatcher of EGL finds no driver where its list of them is a file that is not there.
  ASSERT_EQ(::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json", 1), 0);
  const test::RunResult result = render({ball_, "-o", picture_});
  ASSERT_EQ(::unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES"), 0);
  EXPECT_EQ(result.status, 5) << result.err;
  EXPECT_NE(result.err.find("soms-view render: EGL: "), std::string::npos) << result.err;
  EXPECT_EQ(files_in(folder_.path()), 1U);
}

TEST_F(Render, RefusesADriverWithoutOpenGl33) {
  SOMS_NEEDS_EGL();
  ASSERT_EQ(::setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1), 0);
  const bool mesa = !test_render::can_draw();
  const test::RunResult result = render({ball_, "-o", picture_});
  ASSERT_EQ(::unsetenv("MESA_GL_VERSION_OVERRIDE"), 0);
  if (!mesa) {
    GTEST_SKIP() << "the driver here is not Mesa's, whose version can be lowered";
  }
  EXPECT_EQ(result.status, 5) << result.err;
  EXPECT_NE(result.err.find("3.3"), std::string::npos) << result.err;
}

TEST(PictureSize, IsTwoNumbersAndAnX) {
  EXPECT_EQ(parse_picture_size("640x480"), (Size{640, 480}));
  for (const char* text : {"", "640", "x", "640x", "x480", "640x480x2", "0x1", "-1x5", "1.5x2"}) {
    EXPECT_THROW((void)parse_picture_size(text), Error) << text;
  }
}

}  // namespace
}  // namespace soms::view
