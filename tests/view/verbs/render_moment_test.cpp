// The picture that `soms render` draws of itself: the moment, the contact, and what is named.
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"

#include "apps/view/drawing/palette.h"
#include "tests/support/bodies.h"
#include "tests/view/pictures.h"
#include "tests/view/verbs/render_support.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace soms::view {
namespace {

using test_render::count_red;
using test_render::render;

class RenderMoment : public test_render::BallFolder {
 protected:
  /// What a picture is reported as; its file is `picture_`.
  [[nodiscard]] nlohmann::ordered_json drawn(std::vector<std::string> words) const {
    words.insert(words.end(), {"-o", picture_, "--size", "480x320", "--json", "--no-shadow"});
    const test::RunResult result = render(words);
    EXPECT_EQ(result.status, 0) << result.err;
    return nlohmann::ordered_json::parse(result.out);
  }

  [[nodiscard]] std::string write(const char* name, const Mesh& mesh) const {
    const std::string path = (folder_.path() / name).string();
    write_mesh(path, mesh, MeshFormat::ply);
    return path;
  }

  /// A row of boxes, each a part of an OBJ file.
  [[nodiscard]] std::string write_boxes(
      const char* name, const std::vector<std::pair<std::string, Box>>& boxes) const {
    const std::string path = (folder_.path() / name).string();
    std::ofstream out(path);
    std::size_t first = 1;
    for (const auto& [part, box] : boxes) {
      const Mesh mesh = test::box_body(box.lower, box.upper);
      for (const Vec3& v : mesh.vertices) {
        out << "v " << v.x << ' ' << v.y << ' ' << v.z << '\n';
      }
      out << "g " << part << '\n';
      for (const auto& t : mesh.triangles) {
        out << "f " << first + t[0] << ' ' << first + t[1] << ' ' << first + t[2] << '\n';
      }
      first += mesh.vertices.size();
    }
    return path;
  }

  static constexpr std::size_t kPixels = 480U * 320U;
};

TEST_F(RenderMoment, ThePictureOfTheEmbeddedCityShowsAContactThatIsNamed) {
  SOMS_NEEDS_EGL();
  const nlohmann::ordered_json picture = drawn({});
  EXPECT_GT(picture.at("touching_movers"), 0);
  EXPECT_GT(picture.at("frame"), 0);
  EXPECT_EQ(picture.at("frames"), 600);
  EXPECT_LT(picture.at("frames_searched"), 100);
  EXPECT_EQ(picture.at("camera").at("subject"), "contact");
  EXPECT_EQ(picture.at("camera").at("bodies").size(), 2U);
  const Picture pixels = read_png(picture_);
  EXPECT_GT(count_red(pixels), 60U);
  EXPECT_LT(count_red(pixels), kPixels / 10) << "red marks the contact, not its surroundings";
  EXPECT_GT(count_near(pixels, palette::kBodyA, 60), 200U) << "the mover is blue and seen";
}

TEST_F(RenderMoment, ThePictureOfATownWithCarsShowsAContact) {
  SOMS_NEEDS_EGL();
  const std::string town =
      write("town.ply", generate_city({.triangles = 20'000, .size = 300}).mesh);
  const std::string car = write("car.ply", generate_mover(MoverKind::car));
  const std::vector<std::string> words{town, "--mover", car, "--count", "40"};
  const nlohmann::ordered_json picture = drawn(words);
  ASSERT_GT(picture.at("touching_movers"), 0);
  EXPECT_EQ(picture.at("camera").at("subject"), "contact");
  EXPECT_GT(count_red(read_png(picture_)), 60U);
}

TEST_F(RenderMoment, AFrameWithoutContactNamesTheNearestThatHasOne) {
  SOMS_NEEDS_EGL();
  // A ball comes along x and passes one that stands.
  const std::string route = (folder_.path() / "route.csv").string();
  std::ofstream out(route);
  out << "x,y,z,qw,qx,qy,qz\n";
  for (int k = 0; k < 40; ++k) {
    out << 8 - 0.4 * k << ",0.5,0,1,0,0,0\n";
  }
  out.close();
  std::vector<std::string> words{ball_, "--mover",  ball_,    "--route", route,
                                 "-o",  picture_,   "--size", "90x60",   "--frame",
                                 "0",   "--camera", "contact"};
  const test::RunResult refused = render(words);
  EXPECT_EQ(refused.status, 2) << refused.err;
  const std::size_t at = refused.err.find("give --frame ");
  ASSERT_NE(at, std::string::npos) << refused.err;
  const std::string nearest = std::to_string(std::stoi(refused.err.substr(at + 13)));
  words[10] = nearest;
  EXPECT_EQ(render(words).status, 0);
  words[10] = std::to_string(std::stoi(nearest) - 1);
  EXPECT_EQ(render(words).status, 2) << "it is the first that touches";
  words.erase(words.begin() + 9, words.end());
  const test::RunResult found = render(words);
  EXPECT_EQ(found.status, 0) << found.err;
  EXPECT_NE(found.err.find(", 1 mover touches; the camera looks at ball and ball"),
            std::string::npos)
      << found.err;
}

TEST_F(RenderMoment, RedIsAsLargeAsTheCrossingNotAsThePart) {
  SOMS_NEEDS_EGL();
  const std::string slab = write("slab.ply", test::box_body({-5, -5, -0.15}, {5, 5, 0.15}));
  const std::string pipe = write("pipe.ply", test::box_body({0.9, -0.1, -20}, {1.1, 0.1, 30}));
  const nlohmann::ordered_json picture = drawn({slab, "--mover", pipe, "--pose", "0 0 0"});
  EXPECT_EQ(picture.at("camera").at("subject"), "contact");
  EXPECT_EQ(picture.at("camera").at("bodies"), (nlohmann::ordered_json{"pipe", "slab"}));
  const std::size_t red = count_red(read_png(picture_));
  EXPECT_GT(red, 60U);
  EXPECT_LT(red, kPixels / 25);
}

TEST_F(RenderMoment, TwoKnotsThatTouchAreSeenApartFromTheirContact) {
  SOMS_NEEDS_EGL();
  const std::string knot = write("knot.ply", generate_knot(2000));
  const nlohmann::ordered_json picture = drawn({knot, "--mover", knot, "--pose", "0.5 0.2 0.1"});
  EXPECT_EQ(picture.at("camera").at("subject"), "contact");
  const Picture pixels = read_png(picture_);
  EXPECT_GT(count_red(pixels), 200U);
  EXPECT_LT(count_red(pixels), kPixels / 6);
  EXPECT_GT(count_near(pixels, palette::kBodyA, 70), 2000U);
}

TEST_F(RenderMoment, TwoModelsAloneAreAPairThatTouchesOrHasAGap) {
  SOMS_NEEDS_EGL();
  const std::string apart = write("apart.ply", test::box_body({4, -1, -1}, {6, 1, 1}));
  const std::string near = write("near.ply", test::box_body({0.5, -1, -1}, {3, 1, 1}));
  const nlohmann::ordered_json gap = drawn({ball_, apart});
  EXPECT_EQ(gap.at("camera").at("subject"), "gap");
  EXPECT_EQ(gap.at("touching_pairs"), 0);
  const nlohmann::ordered_json touch = drawn({ball_, near});
  EXPECT_EQ(touch.at("camera").at("subject"), "contact");
  EXPECT_GT(touch.at("touching_pairs"), 0);
  EXPECT_GT(count_red(read_png(picture_)), 60U);
  EXPECT_EQ(drawn({ball_, near, "--camera", "scene"}).at("camera").at("subject"), "scene");
}

TEST_F(RenderMoment, OnePairOfPartsIsShownAndAnotherCanBeChosen) {
  SOMS_NEEDS_EGL();
  const std::string walls = write_boxes(
      "walls.obj", {{"wall-1", {{-1, -4, 0}, {0, 4, 3}}}, {"wall-2", {{9, -4, 0}, {10, 4, 3}}}});
  const std::string pipes = write_boxes("pipes.obj", {{"pipe-1", {{-2, -0.2, 1}, {2, 0.2, 1.4}}},
                                                      {"pipe-2", {{8, 1, 1}, {9.5, 1.4, 1.4}}}});
  const auto bodies = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {walls, "--mover", pipes, "--pose", "0 0 0"});
    return drawn(more).at("camera").at("bodies");
  };
  const nlohmann::ordered_json first{"pipe-1", "wall-1"};
  const nlohmann::ordered_json second{"pipe-2", "wall-2"};
  const nlohmann::ordered_json chosen = bodies({});
  EXPECT_TRUE(chosen == first || chosen == second) << "one that is seen well: " << chosen;
  EXPECT_EQ(bodies({"--clash", "1"}), first);
  const std::size_t red_of_one = count_red(read_png(picture_));
  EXPECT_EQ(bodies({"--clash", "2"}), second);
  EXPECT_EQ(bodies({"--clash", "wall-2"}), second);
  EXPECT_EQ(bodies({"--clash", "wall-2,pipe-2"}), second);
  EXPECT_GT(red_of_one, 60U);
  for (const char* none : {"3", "wall-3"}) {
    const test::RunResult refused =
        render({walls, "--mover", pipes, "--pose", "0 0 0", "-o", picture_, "--clash", none});
    EXPECT_EQ(refused.status, 2) << refused.err;
  }
}

TEST_F(RenderMoment, TwoModelsThatLookYUpStandUpright) {
  SOMS_NEEDS_EGL();
  // Cones whose tips are at +y.
  const auto cone = [](double x) {
    constexpr std::uint32_t kCorners = 24;
    Mesh mesh;
    mesh.vertices = {{x, 3, 0}, {x, 0, 0}};
    for (std::uint32_t k = 0; k < kCorners; ++k) {
      const double turn = k * 2 * std::numbers::pi / kCorners;
      mesh.vertices.push_back({x + std::cos(turn), 0, std::sin(turn)});
      const std::uint32_t next = (k + 1) % kCorners;
      mesh.triangles.push_back({0, 2 + next, 2 + k});
      mesh.triangles.push_back({1, 2 + k, 2 + next});
    }
    return mesh;
  };
  const test::RunResult both = render(
      {write("left.ply", cone(0)), write("right.ply", cone(4)), "-o", picture_, "--size", "90x60"});
  EXPECT_EQ(both.status, 0) << both.err;
  EXPECT_NE(both.err.find("left.ply: looks y up, and is drawn so"), std::string::npos) << both.err;
  EXPECT_NE(both.err.find("right.ply: looks y up, and is drawn so"), std::string::npos);
  const test::RunResult one =
      render({write("left.ply", cone(0)), ball_, "-o", picture_, "--size", "90x60"});
  EXPECT_NE(one.err.find("left.ply: looks y up; assuming z up"), std::string::npos) << one.err;
}

}  // namespace
}  // namespace soms::view
