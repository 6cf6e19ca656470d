#include "soms/store/tree_file.h"

#include "soms/base/error.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/geometry/print.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/tree/layout/detail/wide_tree.h"
#include "soms/tree/refit.h"

#include "tests/store/forged_file.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <vector>

namespace soms {
namespace {

using test::tree_file_of;

Mesh stated_mesh() {
  Mesh mesh = generate_city({.triangles = 3000, .size = 600}).mesh;
  mesh.unit = 0.3048;
  mesh.up = UpAxis::z;
  mesh.georeference = {.crs = "EPSG:25833",
                       .vertical_datum = "DHHN2016",
                       .map_conversion = MapConversion{.eastings = 311988, .scale = 0.999}};
  mesh.notes = {"two of three", ""};
  mesh.parts[1].id = "an id";
  mesh.parts[1].type = "Building";
  mesh.parts[1].attributes = {{"height", "12"}, {"", "no name"}};
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    mesh.faces.push_back(i / 2);
  }
  return mesh;
}

/// A sheet of 40 x 40 squares in steps, whose coordinates no arithmetic rounds.
Mesh stepped_sheet() {
  constexpr std::uint32_t kSide = 40;
  Mesh mesh;
  mesh.source = "arrays";
  for (std::uint32_t i = 0; i <= kSide; ++i) {
    for (std::uint32_t j = 0; j <= kSide; ++j) {
      const std::uint32_t step = (7 * i * i + 13 * j * j + 5 * i * j) % 17;
      mesh.vertices.push_back({i / 8.0, j / 8.0, step / 64.0});
      if (i < kSide && j < kSide) {
        const std::uint32_t at = i * (kSide + 1) + j;
        mesh.triangles.push_back({at, at + 1, at + kSide + 1});
        mesh.triangles.push_back({at + 1, at + kSide + 2, at + kSide + 1});
      }
    }
  }
  return mesh;
}

/// Small triangles in a cube, some of them points.
Mesh random_mesh(Rng& rng, std::size_t triangles) {
  Mesh mesh;
  for (std::size_t i = 0; i < triangles; ++i) {
    const Vec3 at{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const double size = rng.below(8) == 0 ? 0 : 0.1;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int k = 0; k < 3; ++k) {
      mesh.vertices.push_back(
          at + Vec3{rng.uniform(0, size), rng.uniform(0, size), rng.uniform(0, size)});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

std::vector<Shape> shapes_of_all_kinds() {
  Mesh one;
  one.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  std::vector<Shape> shapes;
  for (const Layout layout : {Layout::wide, Layout::compact}) {
    shapes.emplace_back(stated_mesh(), ShapeOptions{.layout = layout});
    shapes.emplace_back(Mesh{}, ShapeOptions{.layout = layout});
    shapes.emplace_back(generate_mover(MoverKind::drone),
                        ShapeOptions{.build = {.rule = Rule::quality}, .layout = layout});
    ShapeOptions thesis{.build = thesis_options(Rule::soms), .layout = layout};
    thesis.build.level = 4;  // leaves of many blocks
    shapes.emplace_back(stated_mesh(), thesis);
    shapes.emplace_back(one, ShapeOptions{.layout = layout});
  }
  const Shape& city = shapes.front();
  std::vector<Vec3> moved(city.mesh().vertices.begin(), city.mesh().vertices.end());
  for (std::size_t i = 0; i < moved.size(); i += 7) {
    moved[i].z += 3;
  }
  shapes.push_back(refit(city, moved));
  return shapes;
}

TEST(TreeFile, OpensTheShapeThatWasSaved) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.somst";
  for (const Shape& shape : shapes_of_all_kinds()) {
    save(path, shape);
    for (const TreeCheck check :
         {TreeCheck::trusted, TreeCheck::safe, TreeCheck::sound, TreeCheck::full}) {
      for (const bool load : {false, true}) {
        const Shape opened = open_shape(path, {.check = check, .load = load});
        EXPECT_EQ(opened, shape) << name(check);
        EXPECT_EQ(opened.mesh(), shape.mesh());
        EXPECT_EQ(*opened.shared_mesh(), static_cast<Mesh>(shape.mesh()));
        EXPECT_EQ(opened.build_options(), shape.build_options());
        EXPECT_EQ(opened.sah_degradation(), shape.sah_degradation());
        ASSERT_NE(opened.tree_file(), nullptr);
        EXPECT_EQ(opened.tree_file()->path, path.string());
        EXPECT_EQ(opened.tree_file()->hash, tree_file_hash(path));
        EXPECT_TRUE(is_tree_file(path));
      }
    }
  }
}

TEST(TreeFile, AnswersAndCostsAreThoseOfTheSavedShape) {
  const Shape car(generate_mover(MoverKind::car));
  test::for_each_case("tree files", 20, [&](Rng& rng) {
    const Layout layout = rng.below(2) == 0 ? Layout::wide : Layout::compact;
    const Shape built(random_mesh(rng, 1 + rng.below(400)), {.layout = layout});
    const Shape opened = open_shape(tree_file_of(built), "bytes");
    const Pose pose = Pose::about_z(rng.uniform(0, 6), {rng.uniform(-2, 2), rng.uniform(-2, 2), 0});
    EXPECT_EQ(overlap(Body(car, pose), Body(opened)), overlap(Body(car, pose), Body(built)));
    EXPECT_EQ(distance(Body(car, pose), Body(opened)), distance(Body(car, pose), Body(built)));
    EXPECT_EQ(overlap(Body(opened, pose), Body(opened)), overlap(Body(built, pose), Body(built)));
  });
}

TEST(TreeFile, BytesDependOnTheMeshAlone) {
  const Mesh mesh = stated_mesh();
  for (const Layout layout : {Layout::wide, Layout::compact}) {
    const std::vector<std::byte> bytes = tree_file_of(Shape(mesh, {.layout = layout}));
    for (const int threads : {1, 2, 7}) {
      const Shape again(mesh, {.keep_tree = threads == 2, .layout = layout}, {.threads = threads});
      EXPECT_TRUE(tree_file_of(again) == bytes) << threads;
    }
    EXPECT_TRUE(tree_file_of(open_shape(bytes, "bytes")) == bytes);
  }
}

/// The file's hash stands for all of its bytes, so it is the same on every machine.
TEST(TreeFile, HashIsGolden) {
  const Shape city(generate_city({.triangles = 3000, .size = 600}).mesh);
  EXPECT_EQ(tree_file_hash(tree_file_of(city), "bytes"), 7699169967071876675U);
}

/// tests/web/tree_files.test.mjs has the same numbers for what WebAssembly writes.
TEST(TreeFile, HashesOfTheSheetAreGolden) {
  const Mesh sheet = stepped_sheet();
  const auto hash_with = [&](Layout layout) {
    return tree_file_hash(tree_file_of(Shape(sheet, {.layout = layout})), "bytes");
  };
  EXPECT_EQ(hash_with(Layout::wide), 0x86d2addf460a240cU);
  EXPECT_EQ(hash_with(Layout::compact), 0x55a8ac8306870da4U);
}

TEST(TreeFile, AnOpenedShapeOutlivesItsFile) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.somst";
  const Shape built(stated_mesh());
  save(path, built);
  const Shape opened = open_shape(path);
  save(path, Shape(generate_mover(MoverKind::car)));
  EXPECT_EQ(opened, built);
  std::filesystem::remove(path);
  EXPECT_EQ(opened, built);
  EXPECT_FALSE(is_tree_file(path));
}

TEST(TreeFile, OpenedShapesAreRefitAndSavedAgain) {
  const Shape built(stated_mesh());
  const std::vector<std::byte> bytes = tree_file_of(built);
  std::vector<Vec3> moved(built.mesh().vertices.begin(), built.mesh().vertices.end());
  moved[0].z += 1;
  const Shape refitted = refit(open_shape(bytes, "bytes"), moved);
  EXPECT_EQ(refitted, refit(built, moved));
  EXPECT_EQ(refitted.tree_file(), nullptr);
  EXPECT_EQ(refitted.layout().least_ids().size(), built.layout().least_ids().size());
}

}  // namespace
}  // namespace soms
