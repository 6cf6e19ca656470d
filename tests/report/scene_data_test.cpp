#include "apps/report/scene_data.h"

#include "soms/generate/shapes.h"

#include "tests/report/reading.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <sstream>

namespace soms::report {

namespace {

constexpr std::size_t kWordsOfContact = 28;
constexpr std::size_t kWordsOfRow = 19;
constexpr std::size_t kWordsOfGap = 26;

Mesh triangle_mesh(const Vec3& a, const Vec3& b, const Vec3& c) {
  Mesh mesh;
  mesh.vertices = {a, b, c};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// A ground of one triangle at map coordinates, and a needle that moves east over it, a meter a
/// step, and touches it from step 3 to 5.
class Field {
 public:
  Field() {
    scene.models = {{ground, "ground"}, {needle, "needle"}};
    scene.bodies = {{0, "field", false}, {1, "needle 1", true}};
    scene.parts = {{.name = "turf", .path = "garden/turf"}};
    scene.rows = {{.a = 1,
                   .b = 0,
                   .part_b = 0,
                   .count = 1,
                   .steps = 3,
                   .begin = 3,
                   .end = 5,
                   .first = {0, 0},
                   .box = {{1'000'007, 2'000'001, 400}, {1'000'007.25, 2'000'001, 400}}}};
    scene.contacts = {{.row = 0,
                       .a = 1,
                       .b = 0,
                       .part_b = 0,
                       .begin = 3,
                       .end = 5,
                       .pairs = {{0, 0}},
                       .pairs_in_all = 1}};
    scene.contacts_in_all = 1;
    scene.steps = {.count = 9, .noun = "frame", .a_second = 60};
    scene.pose = [](std::uint32_t body, std::uint64_t step) {
      return body == 0 ? Pose::identity()
                       : Pose::translation(1'000'004 + static_cast<double>(step), 2'000'001, 400);
    };
  }

  /// The data as the page holds it; `shown` is reported.
  std::string write(const SceneLimits& limits = {}) {
    scene.models[0].mesh = ground;  // tests change them
    scene.models[1].mesh = needle;
    std::ostringstream out;
    shown = write_scene(out, scene, limits);
    return out.str();
  }

  Mesh ground = triangle_mesh({1'000'000, 2'000'000, 400}, {1'000'100, 2'000'000, 400},
                              {1'000'000, 2'000'050, 400});
  Mesh needle = triangle_mesh({0, 0, -1}, {0, 0, 1}, {0.5, 0, 1});
  Scene scene;
  Shown shown;
};

TEST(SceneData, TellsCountsAndNames) {
  Field field;
  const std::string page = field.write();
  const auto json = test::scene_of(page);
  EXPECT_EQ(json["schema"], "soms.scene/3");
  EXPECT_EQ(json["models"][0]["name"], "ground");
  EXPECT_EQ(json["models"][0]["triangles"], 1);
  EXPECT_EQ(json["bodies"]["names"], (std::vector<std::string>{"field", "needle 1"}));
  EXPECT_EQ(json["bodies"]["moves"], (std::vector<int>{0, 1}));
  EXPECT_EQ(json["steps"]["count"], 9);
  EXPECT_EQ(json["steps"]["kept"].size(), 9U);
  EXPECT_EQ(json["contacts"]["listed"], 1);
  EXPECT_EQ(json["contacts"]["all"], 1);
  EXPECT_EQ(json["parts"], std::vector<std::string>{"turf"});
  EXPECT_EQ(json["paths"], std::vector<std::string>{"garden/turf"});
  EXPECT_EQ(json["rows"], 1);
  EXPECT_EQ(field.shown, (Shown{.triangles = 2,
                                .triangles_in_all = 2,
                                .bodies = 2,
                                .bodies_in_all = 2,
                                .rows = 1,
                                .contacts = 1,
                                .contacts_in_all = 1,
                                .steps = 9,
                                .steps_in_all = 9,
                                .is_live = true}));
}

TEST(SceneData, DoesNotShakeAtMapCoordinates) {
  Field field;
  const std::string page = field.write();
  const auto json = test::scene_of(page);
  const double east = json["origin"][0].get<double>();
  const auto poses = test::poses_of(page);
  ASSERT_EQ(poses.size(), 9U);
  const double middle = bounds(field.needle).center().x;
  const double step_of_places = json["place_step"];
  EXPECT_LE(step_of_places, 1e-4);
  for (std::size_t step = 0; step < 9; ++step) {
    const double at = east + poses[step][0];
    EXPECT_NEAR(at, 1'000'004 + static_cast<double>(step) + middle, step_of_places);
    EXPECT_EQ(poses[step][6], 1.0);  // not turned
  }
  const test::PageMesh ground = test::mesh_of(page, "model-0", json["models"][0]["step"]);
  const std::vector<float> still = test::floats_of(test::element(page, "still"));
  ASSERT_EQ(ground.vertices.size(), 3U);
  EXPECT_NEAR(east + static_cast<double>(still[0]) + ground.vertices[0][0], 1'000'000, 1e-4);
}

TEST(SceneData, SaysWhichTrianglesAreOfAPartThatARowNames) {
  Field field;
  for (std::uint32_t k = 1; k < 5; ++k) {
    const double east = 1'000'000 + 5.0 * k;
    field.ground.vertices.insert(
        field.ground.vertices.end(),
        {{east, 2'000'000, 400}, {east + 1, 2'000'000, 400}, {east, 2'000'001, 400}});
    field.ground.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  const auto add_part = [&](const char* name, std::uint32_t first, std::uint32_t count) {
    field.ground.parts.push_back({.name = name, .first = first, .count = count});
  };
  add_part("path", 0, 2);
  add_part("turf", 2, 2);
  field.scene.rows[0].first.b = 3;
  const std::string page = field.write();
  const auto model = test::scene_of(page)["models"][0];
  EXPECT_EQ(test::mesh_of(page, "model-0", model["step"], 5).parts,
            (std::vector<std::array<std::uint64_t, 2>>{{2, 0}, {2, 1}, {1, 0}}));
  EXPECT_TRUE(test::mesh_of(page, "model-1", model["step"], 1).parts.empty());
}

TEST(SceneData, PlacesAContactWhereItIs) {
  Field field;
  const std::string page = field.write();
  const auto json = test::scene_of(page);
  const std::vector<std::uint32_t> words = test::words_of(test::element(page, "contacts"));
  const std::vector<float> floats = test::floats_of(test::element(page, "contacts"));
  ASSERT_EQ(words.size(), kWordsOfContact);
  const std::vector<std::uint32_t> head(words.begin(), words.begin() + 9);
  EXPECT_EQ(head, (std::vector<std::uint32_t>{1, 0, 0xffffffff, 0, 3, 5, 1, 0, 1}));
  const double x = json["origin"][0].get<double>() + static_cast<double>(floats[9]);
  const double z = json["origin"][2].get<double>() + static_cast<double>(floats[11]);
  EXPECT_NEAR(x, 1'000'007.125, 1e-4) << "the middle of the crossing";
  EXPECT_NEAR(z, 400, 1e-4);
  EXPECT_GT(floats[12], 0.5F);  // the reach, of the needle
  EXPECT_LT(floats[12], 2.0F);
  const auto pairs = test::pairs_of(page);
  ASSERT_EQ(pairs.size(), 1U);
  const auto& points = pairs[0].points;
  EXPECT_NEAR(json["origin"][2].get<double>() + points[2][2], 399, 1e-4) << "the tip";
  for (const std::size_t end : {0U, 1U}) {
    EXPECT_NEAR(json["origin"][2].get<double>() + points[end][2], 400, 1e-4);
  }
  EXPECT_NEAR(std::abs(points[0][0] - points[1][0]), 0.25, 1e-4);
  EXPECT_EQ(words[27], 0U) << "its row";
}

TEST(SceneData, PlacesAGapWhereItIs) {
  Field field;
  field.scene.gaps = {{.a = 1,
                       .b = 0,
                       .begin = 1,
                       .end = 4,
                       .nearest = 2,
                       .point_a = {1'000'006, 2'000'001, 401},
                       .point_b = {1'000'006, 2'000'001, 400},
                       .length = "1 </script>"},
                      {.a = 1, .b = 0}};
  field.scene.gaps_in_all = 7;
  const std::string page = field.write({.gaps = 1});
  EXPECT_EQ(field.shown.gaps, 1U);
  EXPECT_EQ(field.shown.gaps_in_all, 7U);
  const auto json = test::scene_of(page);
  EXPECT_EQ(json["gaps"]["listed"], 1);
  EXPECT_EQ(json["gaps"]["all"], 7);
  EXPECT_EQ(json["gaps"]["lengths"], std::vector<std::string>{"1 </script>"});
  const std::vector<std::uint32_t> words = test::words_of(test::element(page, "gaps"));
  const std::vector<float> floats = test::floats_of(test::element(page, "gaps"));
  ASSERT_EQ(words.size(), kWordsOfGap);
  EXPECT_EQ(std::vector<std::uint32_t>(words.begin(), words.begin() + 5),
            (std::vector<std::uint32_t>{1, 0, 1, 4, 2}));
  const std::vector<double> expected{1'000'006, 2'000'001, 401, 1'000'006, 2'000'001, 400};
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(json["origin"][k % 3].get<double>() + static_cast<double>(floats[5 + k]),
                expected[k], 1e-4);
  }
  EXPECT_GE(floats[11], 1.0F) << "all of the segment is seen";
  const double middle = bounds(field.needle).center().x;
  EXPECT_NEAR(json["origin"][0].get<double>() + static_cast<double>(floats[12]), 1'000'006 + middle,
              1e-4)
      << "the pose at the nearest step";
}

TEST(SceneData, KeepsWithinItsLimits) {
  Field field;
  const SceneContact contact = field.scene.contacts.front();
  field.scene.contacts.assign(50, contact);
  field.scene.contacts_in_all = 70;
  field.scene.steps.count = 1000;
  const std::string page = field.write({.pose_bytes = 280, .contacts = 30, .pairs = 20});
  const auto json = test::scene_of(page);
  EXPECT_EQ(field.shown.contacts, 30U);
  EXPECT_EQ(field.shown.contacts_in_all, 70U);
  EXPECT_EQ(field.shown.steps, 10U);
  EXPECT_EQ(field.shown.steps_in_all, 1000U);
  EXPECT_EQ(test::words_of(test::element(page, "contacts")).size(), 30 * kWordsOfContact);
  EXPECT_EQ(test::pairs_of(page).size(), 20U);
  EXPECT_EQ(json["contacts"]["pairs"], 20);
  EXPECT_EQ(json["steps"]["kept"].back(), 999);
}

TEST(SceneData, KeepsTheTrianglesOfAModelThatMovesWhereItTouches) {
  constexpr TriangleId kTouching = 12'345;
  Field field;
  field.needle = generate_knot(20'000);
  field.scene.contacts[0].pairs = {{kTouching, 0}};
  field.scene.pose = [&](std::uint32_t body, std::uint64_t) {
    const Vec3 at = field.ground.vertices[0] - field.needle.triangle(kTouching).a;
    return body == 0 ? Pose::identity() : Pose::translation(at.x, at.y, at.z);
  };
  const std::string page = field.write({.triangles = 2'000});
  const auto json = test::scene_of(page);
  ASSERT_LE(json["models"][1]["drawn"].get<int>(), 2'000);
  const test::PageMesh mesh = test::mesh_of(page, "model-1", json["models"][1]["step"]);
  EXPECT_EQ(mesh.indices.size(), 3 * json["models"][1]["drawn"].get<std::size_t>());
  const double scale = json["scale"];
  const Triangle t = field.needle.triangle(kTouching);
  const Vec3 middle = bounds(field.needle).center();
  for (const Vec3& corner : {t.a, t.b, t.c}) {
    const Vec3 d = (corner - middle) * scale;
    bool kept = false;
    for (const auto& [x, y, z] : mesh.vertices) {
      kept = kept ||
             (std::abs(x - d.x) < 2e-6 && std::abs(y - d.y) < 2e-6 && std::abs(z - d.z) < 2e-6);
    }
    EXPECT_TRUE(kept);
  }
}

TEST(SceneData, PlacesARowAndCountsBeyondThirtyTwoBits) {
  Field field;
  field.scene.rows[0].count = (std::uint64_t{3} << 32) + 7;
  const std::string page = field.write();
  const std::vector<std::uint32_t> words = test::words_of(test::element(page, "rows"));
  ASSERT_EQ(words.size(), kWordsOfRow);
  const std::vector<std::uint32_t> head(words.begin(), words.begin() + 13);
  EXPECT_EQ(head, (std::vector<std::uint32_t>{1, 0, kNoPart, 0, 7, 3, 3, 3, 5, 0, 0, 0, 0}));
  const std::vector<float> floats = test::floats_of(test::element(page, "rows"));
  const double east = test::scene_of(page)["origin"][0].get<double>();
  EXPECT_NEAR(east + static_cast<double>(floats[13]), 1'000'007.125, 1e-4);
  EXPECT_NEAR(static_cast<double>(floats[16]), 0.125, 1e-6);
}

TEST(SceneData, DrawsTheCurveOfARowInItsStepOfMostPairs) {
  Field field;
  SceneRow& row = field.scene.rows[0];
  row.most_pairs = 7;
  row.most_step = 4;
  row.place = {1'000'008.125, 2'000'000, 400};
  row.box = {{1'000'008, 2'000'000, 400}, {1'000'008.25, 2'000'000, 400}};
  row.pairs = {{0, 0}};
  const std::string page = field.write();
  const auto json = test::scene_of(page);
  const std::vector<std::uint32_t> rows = test::words_of(test::element(page, "rows"));
  EXPECT_EQ(rows[11], 7U);
  EXPECT_EQ(rows[12], 4U);
  const std::vector<std::uint32_t> words = test::words_of(test::element(page, "curves"));
  const std::vector<float> floats = test::floats_of(test::element(page, "curves"));
  constexpr std::size_t kWordsOfCurve = 21;
  ASSERT_EQ(words.size(), kWordsOfCurve);
  EXPECT_EQ(words[0], 0U) << "its row";
  EXPECT_EQ(words[1], 1U) << "its lines";
  const double east = json["origin"][0].get<double>();
  EXPECT_NEAR(east + static_cast<double>(floats[2]), 1'000'008.125, 1e-4);
  EXPECT_GT(floats[5], 0.1F) << "its reach";
  const double middle = bounds(field.needle).center().x;
  EXPECT_NEAR(east + static_cast<double>(floats[7]), 1'000'008 + middle, 1e-4)
      << "the mover in that step";
  const auto lines = test::lines_of(page, {words[1]});
  const double step = static_cast<double>(floats[6]);
  EXPECT_NEAR(std::abs(static_cast<double>(lines[0][3] - lines[0][0])) * step, 0.25, 2 * step);
  EXPECT_LE(step, 0.25 / 2048);
}

TEST(SceneData, HasACoarseStandInOfALargeModelBeforeTheScript) {
  Field field;
  field.needle = generate_knot(60'000);
  field.scene.models[1].mesh = field.needle;
  std::ostringstream out;
  field.shown = write_scene(out, field.scene, {}, [&] { out << "<script>let it = 1</script>"; });
  const std::string page = out.str();
  const auto json = test::scene_of(page);
  const test::PageMesh coarse = test::mesh_of(page, "coarse-1", json["models"][1]["step"]);
  EXPECT_EQ(coarse.indices.size(), 3 * json["models"][1]["coarse"].get<std::size_t>());
  EXPECT_LE(json["models"][1]["coarse"], 15'000);
  EXPECT_GT(json["models"][1]["coarse"], 3'000);
  EXPECT_EQ(json["models"][0]["coarse"], 0);
  const std::size_t script = page.find("let it");
  EXPECT_LT(page.find("\"soms-coarse-1\""), script);
  EXPECT_LT(page.find("\"soms-model-0\""), script);
  EXPECT_LT(page.find("\"soms-scene\""), script);
  EXPECT_GT(page.find("\"soms-model-1\""), script);
}

TEST(SceneData, R116HoldsEveryRowWhateverItsLimits) {
  constexpr std::size_t kRows = 100'000;
  Field field;
  const SceneRow row = field.scene.rows.front();
  field.scene.rows.assign(kRows, row);
  const std::string page = field.write({.contacts = 1});
  EXPECT_EQ(field.shown.rows, kRows);
  EXPECT_EQ(test::scene_of(page)["rows"], kRows);
  EXPECT_EQ(test::words_of(test::element(page, "rows")).size(), kRows * kWordsOfRow);
  EXPECT_LT(page.size(), 110 * kRows + 10'000);
}

TEST(SceneData, SharesPairsOfTrianglesFairly) {
  Field field;
  const SceneContact contact = field.scene.contacts.front();
  field.scene.contacts.assign(30, contact);
  for (SceneContact& each : field.scene.contacts) {
    each.pairs.assign(16, {0, 0});
  }
  const std::string page = field.write({.pairs = 40});
  const std::vector<std::uint32_t> words = test::words_of(test::element(page, "contacts"));
  std::uint32_t sum = 0;
  for (std::size_t k = 0; k < 30; ++k) {
    sum += words[kWordsOfContact * k + 8];
    EXPECT_GE(words[kWordsOfContact * k + 8], 1U) << k;
  }
  EXPECT_EQ(sum, 40U);
}

TEST(SceneData, StaysBelowTwentyMegabytes) {
  Field field;
  field.ground = generate_knot(900'000);
  field.needle = generate_knot(50'000);
  field.scene.bodies.resize(60'000, {1, std::string(40, 'n'), true});
  field.scene.pose = [](std::uint32_t, std::uint64_t) { return Pose(); };
  SceneContact contact = field.scene.contacts.front();
  contact.pairs.assign(40, {0, 0});
  SceneRow row = field.scene.rows.front();
  for (std::uint32_t k = 0; k < 30'000; ++k) {
    if (k < 10'000) {
      field.scene.parts.push_back({.name = "part " + std::to_string(k)});
      row.part_a = contact.part_a = k + 1;
      field.scene.rows.push_back(row);
    }
    field.scene.contacts.push_back(contact);
  }
  field.scene.steps.count = 100'000;
  const std::string page = field.write();
  EXPECT_LT(page.size() + 700'000, 20'000'000U);
  EXPECT_LE(field.shown.triangles, 300'000U);
  EXPECT_GE(field.shown.triangles, 50'000U);
  EXPECT_EQ(field.shown.triangles_in_all, 950'000U);
  EXPECT_EQ(field.shown.bodies, 20'000U);
}

TEST(SceneData, ScalesWhatFloatsCannotHold) {
  Field field;
  for (Mesh* mesh : {&field.ground, &field.needle}) {
    for (Vec3& v : mesh->vertices) {
      v = v * 0x1p200;
    }
  }
  field.scene.pose = [](std::uint32_t, std::uint64_t) { return Pose(); };
  const std::string page = field.write();
  EXPECT_LT(test::scene_of(page)["scale"].get<double>(), 0x1p-200);
  const auto pairs = test::pairs_of(page);
  ASSERT_EQ(pairs.size(), 1U);
  double size = 0;
  for (const auto& [x, y, z] : pairs[0].points) {
    EXPECT_TRUE(std::isfinite(x) && std::isfinite(y) && std::isfinite(z));
    size = std::max(size, std::abs(x));
  }
  EXPECT_GT(size, 0.1) << "what floats hold";
}

TEST(SceneData, TurnsAsThePoseDoes) {
  const double half = std::sqrt(0.5);
  const std::vector<std::array<double, 4>> turns{{1, 0, 0, 0}, {half, 0, 0, half},
                                                 {0, 1, 0, 0}, {0, 0, 1, 0},
                                                 {0, 0, 0, 1}, {0.5, -0.5, 0.5, 0.5}};
  for (const auto& [w, x, y, z] : turns) {
    Field field;
    field.scene.steps = {};
    field.scene.contacts.clear();
    const Pose pose = Pose::from_quaternion(w, x, y, z, {1'000'000, 2'000'000, 400});
    field.scene.pose = [&](std::uint32_t body, std::uint64_t) { return body == 0 ? Pose() : pose; };
    const auto poses = test::poses_of(field.write());
    ASSERT_EQ(poses.size(), 1U);
    const auto& q = poses[0];
    const double same = q[3] * x + q[4] * y + q[5] * z + q[6] * w;
    EXPECT_NEAR(std::abs(same), 1, 2e-5);
  }
}

TEST(SceneData, TakesASceneOfNothing) {
  std::ostringstream out;
  const Mesh none;
  Scene scene;
  scene.models = {{none, "nothing"}};
  scene.bodies = {{0, "nothing", false}};
  scene.pose = [](std::uint32_t, std::uint64_t) { return Pose(); };
  EXPECT_EQ(write_scene(out, scene).triangles, 0U);
  EXPECT_EQ(test::scene_of(out.str())["contacts"]["all"], 0);
}

TEST(SceneData, EscapesNames) {
  Field field;
  const std::string bad = "</script><script>alert(1)</script>\"\\\n";
  field.scene.models[0].name = bad;
  field.scene.bodies[0].name = bad;
  field.scene.parts[0] = {.name = bad, .path = bad + bad};
  field.scene.contact = {bad, bad};
  field.scene.steps.noun = bad;
  const std::string page = field.write();
  EXPECT_EQ(page.find("alert(1)</"), std::string::npos);
  const auto json = test::scene_of(page);
  EXPECT_EQ(json["models"][0]["name"], bad);
  EXPECT_EQ(json["bodies"]["names"][0], bad);
  EXPECT_EQ(json["parts"][0], bad);
  EXPECT_EQ(json["paths"][0], bad + bad);
  EXPECT_EQ(json["contacts"]["many"], bad);
  EXPECT_EQ(json["steps"]["noun"], bad);
}

}  // namespace

}  // namespace soms::report
