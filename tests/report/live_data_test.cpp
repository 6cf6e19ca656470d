#include "apps/report/live_data.h"

#include "soms/generate/shapes.h"

#include "apps/report/placing.h"
#include "apps/report/scene_data.h"
#include "tests/report/reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace soms::report {

namespace {

/// Reads what `ExactMesh` writes, by the words of live_data.h: corners of triangles.
class ExactCorners {
 public:
  ExactCorners(std::string_view page, const std::string& id, bool floats)
      : bytes_(test::bytes_of(test::element(page, id))), floats_(floats) {}

  std::vector<Vec3> read() {
    std::vector<Vec3> vertices;
    std::vector<Vec3> corners;
    while (at_ < bytes_.size()) {
      const std::uint64_t back = number();
      if (back == 0) {
        const double x = coordinate();
        const double y = coordinate();
        vertices.push_back({x, y, coordinate()});
      }
      corners.push_back(vertices.at(vertices.size() - (back == 0 ? 1 : back)));
    }
    return corners;
  }

 private:
  std::uint64_t number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0;; shift += 7) {
      const std::uint8_t byte = bytes_.at(at_++);
      value |= std::uint64_t{byte & 0x7fU} << shift;
      if (byte < 0x80U) {
        return value;
      }
    }
  }

  double coordinate() {
    double wide = 0;
    float narrow = 0;
    const std::size_t size = floats_ ? sizeof(narrow) : sizeof(wide);
    EXPECT_LE(at_ + size, bytes_.size()) << "cut off";
    std::memcpy(floats_ ? static_cast<void*>(&narrow) : &wide, &bytes_.at(at_),
                std::min(size, bytes_.size() - at_));
    at_ += size;
    return floats_ ? double{narrow} : wide;
  }

  std::vector<std::uint8_t> bytes_;
  bool floats_;
  std::size_t at_ = 0;
};

std::vector<double> doubles_of(std::string_view base64) {
  const std::vector<std::uint8_t> bytes = test::bytes_of(base64);
  std::vector<double> numbers(bytes.size() / sizeof(double));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

std::vector<Vec3> corners_of(const Mesh& mesh) {
  std::vector<Vec3> corners;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    corners.insert(corners.end(), {t.a, t.b, t.c});
  }
  return corners;
}

/// Two knots: one of doubles that moves, one of floats that stands still, at poses that no float
/// has.
class LiveScene : public ::testing::Test {
 protected:
  LiveScene() {
    for (Vec3& at : narrow_.vertices) {
      at = {rounded(at.x), rounded(at.y), rounded(at.z)};
    }
    scene_.models = {{wide_, "wide"}, {narrow_, "narrow"}};
    scene_.bodies = {{0, "mover", true}, {1, "still", false}, {1, "mover 2", true}};
    scene_.steps.count = 3;
    scene_.pose = [](std::uint32_t body, std::uint64_t step) {
      return Pose::translation(0.1 + body, 0.1 * static_cast<double>(step), 1e-9);
    };
  }

  static double rounded(double value) {
    const volatile auto narrow = static_cast<float>(value);
    return double{narrow};
  }

  std::string written(const SceneLimits& limits = {}) {
    std::ostringstream out;
    shown_ = write_scene(out, scene_, limits);
    return out.str();
  }

  Mesh wide_ = generate_knot(300);
  Mesh narrow_ = generate_knot(200);
  Scene scene_;
  Shown shown_;
};

TEST_F(LiveScene, HoldsTrianglesAsTheyAreInOrder) {
  const std::string page = written();
  EXPECT_TRUE(shown_.is_live);
  const auto live = test::scene_of(page)["live"];
  ASSERT_FALSE(live["models"][0]["floats"]);
  ASSERT_TRUE(live["models"][1]["floats"]);
  EXPECT_EQ(ExactCorners(page, "exact-0", false).read(), corners_of(wide_));
  EXPECT_EQ(ExactCorners(page, "exact-1", true).read(), corners_of(narrow_));
}

TEST_F(LiveScene, HoldsPosesAsTheyAreStillOnesFirst) {
  const std::vector<double> poses = doubles_of(test::element(written(), "exact-poses"));
  std::vector<double> expected;
  const auto add = [&](std::uint32_t body, std::uint64_t step) {
    const Pose pose = scene_.pose(body, step);
    expected.insert(expected.end(), pose.m.begin(), pose.m.end());
  };
  add(1, 0);
  for (std::uint64_t step = 0; step < 3; ++step) {
    add(0, step);
    add(2, step);
  }
  EXPECT_EQ(poses, expected);
}

TEST_F(LiveScene, LeavesOutAllTrianglesIfThereIsNoRoom) {
  SceneLimits limits;
  limits.exact_bytes = 3000;
  const std::string page = written(limits);
  EXPECT_FALSE(shown_.is_live);
  EXPECT_EQ(page.find("soms-exact"), std::string::npos);
  const auto live = test::scene_of(page)["live"];
  EXPECT_EQ(live["room"], 3000);
  EXPECT_TRUE(live["models"].empty());
}

TEST_F(LiveScene, KeepsWhatIsNearRowsIfThereIsNoRoomForAll) {
  // A floor of many triangles, a small mover that touches one corner of it.
  Mesh floor;
  for (std::uint32_t k = 0; k < 2000; ++k) {
    const auto x = static_cast<double>(k);
    floor.vertices.insert(floor.vertices.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    floor.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  scene_.models = {{wide_, "wide"}, {floor, "floor"}};
  scene_.bodies = {{0, "mover", true}, {1, "floor", false}};
  scene_.pose = [](std::uint32_t, std::uint64_t) { return Pose::identity(); };
  SceneRow row{.a = 0, .b = 1};
  row.box.grow(Vec3{10, 0, 0});
  scene_.rows = {row};
  SceneLimits limits;
  limits.exact_bytes = 20000;
  const std::string page = written(limits);
  EXPECT_TRUE(shown_.is_live);
  const auto live = test::scene_of(page)["live"];
  ASSERT_EQ(live["near"].size(), 1U);
  const std::vector<double> near = live["near"][0];
  EXPECT_LT(near[0], 10 - length(bounds(wide_).extent()));
  EXPECT_EQ(ExactCorners(page, "exact-0", false).read(), corners_of(wide_));
  std::vector<Vec3> expected;
  for (TriangleId i = 0; i < floor.triangles.size(); ++i) {
    const Triangle t = floor.triangle(i);
    if (t.b.x >= near[0] && t.a.x <= near[3]) {
      expected.insert(expected.end(), {t.a, t.b, t.c});
    }
  }
  ASSERT_LT(expected.size(), 3 * floor.triangles.size());
  EXPECT_EQ(ExactCorners(page, "exact-1", true).read(), expected);
  EXPECT_TRUE(test::scene_of(written())["live"]["near"].empty()) << "there is room for all";
}

TEST_F(LiveScene, LeavesOutPosesOfMoversIfThereIsNoRoom) {
  SceneLimits limits;
  limits.exact_pose_bytes = 6 * 96 - 1;
  const std::string page = written(limits);
  EXPECT_TRUE(shown_.is_live);
  EXPECT_FALSE(test::scene_of(page)["live"]["movers"]);
  EXPECT_EQ(doubles_of(test::element(page, "exact-poses")).size(), 12U);
  limits.exact_pose_bytes = 6 * 96;
  EXPECT_TRUE(test::scene_of(written(limits))["live"]["movers"]);
}

TEST_F(LiveScene, LeavesOutPosesOfMoversIfSomeMoversAreLeftOut) {
  SceneLimits limits;
  limits.bodies = 2;
  EXPECT_FALSE(test::scene_of(written(limits))["live"]["movers"]);
}

TEST_F(LiveScene, HoldsNothingIfNothingMoves) {
  for (SceneBody& body : scene_.bodies) {
    body.moves = false;
  }
  const std::string page = written();
  EXPECT_FALSE(shown_.is_live);
  EXPECT_TRUE(test::scene_of(page)["live"].is_null());
}

TEST(ExactMesh, KeepsDoublesThatFloatsAlmostHave) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, std::nextafter(1.0, 2.0)}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_FALSE(ExactMesh(mesh).has_floats());
  mesh.vertices[2].z = 1e300;
  EXPECT_FALSE(ExactMesh(mesh).has_floats());
  mesh.vertices[2].z = -0.0;
  EXPECT_TRUE(ExactMesh(mesh).has_floats());
  EXPECT_EQ(ExactMesh(mesh).bytes(), 3 * (1 + 3 * sizeof(float)));
}

}  // namespace

}  // namespace soms::report
