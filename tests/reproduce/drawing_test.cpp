#include "thesis/pictures/drawing.h"

#include "soms/generate/urban.h"

#include "tests/reproduce/well_formed.h"
#include "thesis/pictures/projection.h"
#include "thesis/trees/facet_paths.h"

#include <gtest/gtest.h>

#include <array>

namespace soms::reproduce {
namespace {

/// Two triangles, the first before the second as seen by `flat_view`.
Mesh stacked() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 1}, {4, 0, 1}, {0, 4, 1}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  return mesh;
}

Facet facet(std::array<Vec3, 3> corners, int color) {
  return {.corners = corners, .color = color};
}

TEST(Drawing, IsWellFormedAndNamesItsPanels) {
  const Mesh mesh = stacked();
  Drawing drawing{.title = "Planes & <boxes>", .view = axonometric(UpAxis::z)};
  drawing.keys = {{KeyKind::fill, kClay, "triangles"},
                  {KeyKind::box, 0, "box"},
                  {KeyKind::dashed_box, 1, "inner box"},
                  {KeyKind::plane, 2, "plane"},
                  {KeyKind::point, kHighlight, "midpoint"}};
  Panel panel{.title = "first <panel>", .note = "2 boxes"};
  panel.meshes = {{.mesh = &mesh, .colors = {kHighlight, 3}}};
  panel.boxes = {{.box = bounds(mesh)}, {.box = bounds(mesh), .color = 1, .dashed = true}};
  panel.points = {{.at = {1, 1, 1}}};
  panel.planes = {{.axis = 0, .value = 2, .within = bounds(mesh)}};
  drawing.panels = {panel, panel, {.title = "without anything"}};
  const std::string svg = draw(drawing);
  EXPECT_EQ(test::markup_fault(svg), "");
  EXPECT_EQ(test::count_of(svg, ">first &lt;panel&gt;<"), 2U);
  EXPECT_EQ(test::count_of(svg, ">without anything<"), 1U);
  EXPECT_TRUE(test::values_of(svg, "id").empty());
  EXPECT_EQ(svg, draw(drawing));
  EXPECT_EQ(test::markup_fault(draw(Drawing{.title = "empty", .view = flat_view()})), "");
}

TEST(Drawing, DrawsABoxAsRectangleWhereTheViewIsFlat) {
  Drawing drawing{.view = flat_view(), .columns = 1};
  drawing.panels = {{.title = "", .boxes = {{.box = {{0, 0, 0}, {2, 1, 0}}}}}};
  EXPECT_EQ(test::count_of(draw(drawing), "<rect"), 2U);  // the paper and the box
  drawing.view = axonometric(UpAxis::z);
  EXPECT_EQ(test::count_of(draw(drawing), "<rect"), 1U);
}

TEST(Drawing, KeepsItsBudgetAndSaysWhatIsLeftOut) {
  const Mesh city = generate_urban(UrbanScene::mixed);
  Drawing drawing{.title = "city", .view = axonometric(UpAxis::z), .columns = 1};
  drawing.panels = {{.title = "whole", .meshes = {{.mesh = &city}}}};
  const std::string whole = draw(drawing);
  EXPECT_EQ(test::count_of(whole, "pieces drawn"), 0U);
  EXPECT_LT(whole.size(), drawing.budget);
  drawing.budget = 40'000;
  const std::string small = draw(drawing);
  EXPECT_LT(small.size(), 45'000U);
  EXPECT_GT(small.size(), 20'000U);
  EXPECT_GE(test::count_of(small, "pieces drawn"), 1U);
}

TEST(Projection, SeesAlongTheView) {
  const look::CameraFrame flat = frame_of(flat_view());
  EXPECT_TRUE(is_flat(flat));
  EXPECT_EQ(flat.on_page({3, 4, 5}), (Vec3{3, -4, -5}));
  const look::CameraFrame above = frame_of(axonometric(UpAxis::z));
  EXPECT_FALSE(is_flat(above));
  EXPECT_LT(above.on_page({0, 0, 1}).y, above.on_page({0, 0, 0}).y);
  EXPECT_LT(above.on_page({0, 0, 1}).z, above.on_page({0, 0, 0}).z);
  const look::CameraFrame bunny = frame_of(axonometric(UpAxis::y));
  EXPECT_LT(bunny.on_page({0, 1, 0}).y, bunny.on_page({0, 0, 0}).y);
}

TEST(Projection, DropsWhatIsHiddenAndPaintsFarOnesFirst) {
  const std::array<Vec3, 3> large{{{0, 0, 1}, {40, 0, 1}, {0, 40, 1}}};
  const std::array<Vec3, 3> behind{{{2, 2, 5}, {8, 2, 5}, {2, 8, 5}}};
  const std::array<Vec3, 3> beside{{{30, 30, 9}, {39, 30, 9}, {39, 39, 9}}};
  std::vector<Facet> facets{facet(large, 0), facet(behind, 1), facet(beside, 2)};
  keep_visible(facets, 40, 40);
  ASSERT_EQ(facets.size(), 2U);
  EXPECT_EQ(facets[0].color, 2);
  EXPECT_EQ(facets[1].color, 0);
  // Half of 40 by 40 pixels, four samples each.
  EXPECT_NEAR(facets[1].samples, 3200, 90);
}

TEST(Projection, CutsLongFacetsIntoTheSameArea) {
  std::vector<Facet> facets{facet({{{0, 0, 0}, {300, 0, 3}, {0, 50, 0}}}, 0)};
  cut_long(facets, 60);
  double area = 0;
  for (const Facet& f : facets) {
    const auto& [a, b, c] = f.corners;
    area += 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = f.corners[k];
      const Vec3& q = f.corners[(k + 1) % 3];
      EXPECT_LE((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y), 3600 + 1e-6);
    }
  }
  EXPECT_NEAR(area, 7500, 1e-6);
  EXPECT_GT(facets.size(), 5U);
}

TEST(FacetPaths, ShareAPathOnlyWhereNothingBetweenIsCovered) {
  const auto square = [](double x, int color) {
    return facet({{{x, 0, 0}, {x + 8, 0, 0}, {x, 8, 0}}}, color);
  };
  const std::vector<Facet> apart{square(0, 0), square(20, 1), square(40, 0)};
  EXPECT_EQ(facet_paths(apart).size(), 2U);
  const std::vector<Facet> stacked{square(0, 0), square(4, 1), square(6, 0)};
  const std::vector<FacetPath> paths = facet_paths(stacked);
  ASSERT_EQ(paths.size(), 3U);
  EXPECT_EQ(paths[0].fill, paths[2].fill);
  EXPECT_EQ(paths[0].data, "M0 0l80 0-80 80z");
}

}  // namespace
}  // namespace soms::reproduce
