#include "apps/report/parts_page.h"

#include "soms/generate/shapes.h"

#include "tests/report/reading.h"

#include <gtest/gtest.h>

#include <sstream>

namespace soms::report {

namespace {

/// Spheres in a row, the first of which rows name.
class Balls {
 public:
  Balls(std::size_t count, std::size_t listed, std::uint64_t triangles) {
    for (std::size_t k = 0; k < count; ++k) {
      Mesh ball = generate_sphere(triangles);
      for (Vec3& vertex : ball.vertices) {
        vertex.x += 3 * static_cast<double>(k);
      }
      meshes.push_back(std::move(ball));
    }
    for (std::size_t k = 0; k < count; ++k) {
      parts.push_back({meshes[k], k < listed, {}});
    }
  }

  std::vector<Mesh> meshes;
  std::vector<PagePart> parts;
};

TEST(PartsData, DrawsAllThatFits) {
  const Balls balls(4, 2, 200);
  const PartsData data(balls.parts, {});
  const ShownParts& shown = data.shown();
  EXPECT_EQ(shown.parts, 4U);
  EXPECT_EQ(shown.triangles, shown.triangles_in_all);
  EXPECT_EQ(shown.simplified, 0U);
  EXPECT_EQ(shown.listed, 2U);
  EXPECT_EQ(data.number(0), 0U);
  EXPECT_EQ(data.number(3), 3U);
}

TEST(PartsData, DrawsWhatRowsNameFirst) {
  Balls balls(4, 4, 200);
  balls.parts[0].is_listed = false;
  balls.parts[1].is_listed = false;
  const std::uint64_t each = balls.meshes[0].triangles.size();
  const PartsData data(balls.parts, {.triangles = 2 * each});
  EXPECT_EQ(data.number(0), kNoPart);
  EXPECT_EQ(data.number(1), kNoPart);
  EXPECT_EQ(data.number(2), 0U);
  EXPECT_EQ(data.shown().triangles, 2 * each);
  EXPECT_EQ(data.shown().parts, 2U);
  EXPECT_EQ(data.shown().parts_in_all, 4U);
}

TEST(PartsData, DrawsAtLeastABoxOfWhatRowsName) {
  const Balls balls(30, 30, 400);
  const PartsData data(balls.parts, {.triangles = 10});
  EXPECT_EQ(data.shown().parts, 30U);
  EXPECT_EQ(data.shown().simplified, 30U);
  EXPECT_LE(data.shown().triangles, 30U * 12U);
  EXPECT_GT(data.shown().triangles, 0U);
  for (std::size_t k = 0; k < 30; ++k) {
    EXPECT_EQ(data.number(k), k);
  }
}

TEST(PartsData, KeepsFarAndTinyScenes) {
  Mesh far;
  far.vertices = {{1e9, 2e9, 3e9}, {1e9 + 1e-4, 2e9, 3e9}, {1e9, 2e9 + 1e-4, 3e9}};
  far.triangles = {{0, 1, 2}};
  const std::vector<PagePart> parts{{far, true, {}}};
  const PartsData data(parts, {});
  EXPECT_EQ(data.shown().triangles, 1U);
  EXPECT_GT(data.scale(), 1);
  EXPECT_NEAR(data.place(far.vertices[0]).x, -data.half().x, 1e-2);
}

TEST(PartsPage, HoldsEachRowAndObeysNoName) {
  const Balls balls(2, 2, 50);
  PartsPage page{
      .page = {.title = "<b>list</b>", .lead = "", .facts = {}, .plots = {}, .notes = {}}};
  page.parts = balls.parts;
  page.sides = {{R"({"part":"</script><script>"})", 0}, {R"({"part":"b"})", kNoPart}};
  page.rows = 3;
  page.row = [](std::size_t k) {
    PageRow row{.json = R"({"a":0,"b":1,"key":"row )" + std::to_string(k) + R"("})"};
    if (k == 1) {
      row.sight = PageSight{.reach = 2, .toward = {0, 0, 1}};
      row.lines = {{Vec3{0, 0, 0}, Vec3{1, 0, 0}}};
    }
    return row;
  };
  std::ostringstream out;
  const ShownParts shown = write_parts_page(out, page);
  const std::string text = out.str();
  EXPECT_EQ(shown.parts, 2U);
  for (const char* const words : {"row 0", "row 1", "row 2", "\\u003c/script\\u003e",
                                  "&lt;b&gt;list", "\"of_sides\":[0,-1]", "id=\"soms-parts\""}) {
    EXPECT_NE(text.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(text.find("</script><script>\"}"), std::string::npos);
}

}  // namespace

}  // namespace soms::report
