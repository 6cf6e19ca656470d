#include "thesis/trips/models.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/generate/urban.h"
#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"

#include "apps/output/sha256.h"
#include "tests/generate/closed.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace soms::reproduce {

using command::sha256;
using command::sha256_of_file;

namespace {

namespace fs = std::filesystem;

constexpr Needs kObjects{.objects = true};
constexpr Needs kOnlyScenes{.scenes = true};
constexpr Needs kCities{.cities = true};
constexpr Needs kAll{.objects = true, .scenes = true, .cities = true};

/// A folder of models that is removed at the end.
class Folder {
 public:
  [[nodiscard]] const fs::path& path() const { return folder_.path(); }

  /// A sphere under this name, in its folder.
  void put(const std::string& name, std::uint64_t triangles) const {
    fs::create_directories((path() / name).parent_path());
    write_mesh(path() / name, generate_sphere(triangles), format_for(name));
  }

  void put_broken(const std::string& name) const {
    fs::create_directories((path() / name).parent_path());
    std::ofstream(path() / name) << "no model";
  }

 private:
  test::TemporaryFolder folder_;
};

std::vector<std::string> names_of(const std::vector<Model>& models) {
  std::vector<std::string> names;
  for (const Model& model : models) {
    names.push_back(model.name);
  }
  return names;
}

using Names = std::vector<std::string>;

bool holds(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(Models, AreAllGeneratedWithoutAFolder) {
  const Models models = find_models({}, kAll);
  EXPECT_EQ(names_of(models.objects), (Names{"bunny", "venus", "teapot"}));
  EXPECT_EQ(names_of(models.scenes), (Names{"u_mixed", "u_boxes", "u_plain"}));
  EXPECT_TRUE(models.cities.empty());
  EXPECT_TRUE(models.remarks.empty());
  for (const auto* kind : {&models.objects, &models.scenes}) {
    for (const Model& model : *kind) {
      EXPECT_TRUE(model.stand_in);
      EXPECT_TRUE(holds(model.title, "stand-in: ")) << model.title;
      EXPECT_TRUE(model.file.empty());
      EXPECT_EQ(model.hash, corner_hash(*model.mesh));
    }
  }
  EXPECT_EQ(models.objects[0].trouble, "no folder of models was given");
  EXPECT_EQ(models.scenes[0].trouble, "");
}

TEST(Models, HaveTheSha256OfTheirFiles) {
  const Folder folder;
  folder.put("bun_zipper_res4.ply", 20);
  folder.put("cities/town.ply", 30);
  const Models models = find_models(folder.path(), kAll);
  EXPECT_EQ(models.objects[0].sha256, sha256_of_file(folder.path() / "bun_zipper_res4.ply"));
  EXPECT_EQ(models.cities.at(0).sha256, sha256_of_file(folder.path() / "cities/town.ply"));
  EXPECT_EQ(models.objects[0].sha256.size(), 64U);
  EXPECT_EQ(models.objects[1].sha256, "");  // a stand-in has no file
  for (const Model& scene : models.scenes) {
    EXPECT_EQ(scene.sha256, sha256(scene_file(scene)));
  }
}

TEST(Models, AreOnlyThoseThatAreNeeded) {
  EXPECT_TRUE(find_models({}, kObjects).scenes.empty());
  EXPECT_TRUE(find_models({}, kOnlyScenes).objects.empty());
  EXPECT_TRUE(find_models({}, {}).objects.empty());
}

TEST(Models, HaveStandInsOfTheSizeAndPlaceOfTheirModels) {
  const Models models = find_models({}, kObjects);
  EXPECT_EQ(models.objects[0].mesh->triangles.size(), 948U);
  EXPECT_EQ(models.objects[1].mesh->triangles.size(), 1416U);
  EXPECT_EQ(models.objects[2].mesh->triangles.size(), 6320U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(test::faulty_edges(*models.objects[i].mesh), 0U);
    EXPECT_GT(test::volume6(*models.objects[i].mesh), 0);
  }
  // y is up, as in the files: the bunny's box is 0.0336 to 0.1819, that of Venus -4.54 to 5.96.
  const Box bunny = bounds(*models.objects[0].mesh);
  EXPECT_NEAR(bunny.lower.y, 0.0336, 1e-4);
  EXPECT_NEAR(bunny.upper.y, 0.1819, 1e-4);
  EXPECT_LT(bunny.extent().x, 0.151);
  const Box venus = bounds(*models.objects[1].mesh);
  EXPECT_NEAR(venus.lower.y, -4.54, 1e-9);
  EXPECT_NEAR(venus.upper.y, 5.96, 1e-9);
  const Box teapot = bounds(*models.objects[2].mesh);
  EXPECT_EQ(teapot.lower.y, 0);
  EXPECT_EQ(teapot.upper.y, 3.15);
  EXPECT_EQ(teapot.upper.z, 3);
}

TEST(Models, HaveTheScenesOfTheGoldenTablesReadFrom3ds) {
  const Models models = find_models({}, kOnlyScenes);
  const std::vector<std::pair<UrbanScene, std::uint64_t>> expected{
      {UrbanScene::mixed, 0x5e44b5637f4cb56cULL},
      {UrbanScene::boxes, 0x57cb92e64471a071ULL},
      {UrbanScene::plain, 0xb2dc50f5a09a47cdULL}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Model& scene = models.scenes[i];
    EXPECT_EQ(scene.mesh->triangles.size(), 5672U);
    EXPECT_EQ(scene.hash, expected[i].second) << scene.name;
    EXPECT_EQ(scene.hash, corner_hash(generate_urban(expected[i].first)));
    EXPECT_EQ(scene.mesh->up, UpAxis::z);
    EXPECT_TRUE(holds(scene.title, "written as .3ds and read back")) << scene.title;
    const std::string bytes = scene_file(scene);
    EXPECT_EQ(scene.bytes, bytes.size());
    const Mesh back = read_mesh(std::as_bytes(std::span(bytes)), scene.name + ".3ds");
    EXPECT_EQ(back.triangles, scene.mesh->triangles);
    EXPECT_EQ(back.vertices, scene.mesh->vertices);
    EXPECT_EQ(back.parts, scene.mesh->parts);
  }
  EXPECT_EQ(models.scenes[0].mesh->parts.size(), 4U);
}

TEST(Models, AreReadFromTheFolderOrItsFolderPly) {
  const Folder folder;
  folder.put("bun_zipper_res4.ply", 20);
  folder.put("ply/bun_zipper_res4.ply", 30);
  folder.put("ply/venus.ply", 40);
  const Models models = find_models(folder.path(), kObjects);
  ASSERT_EQ(names_of(models.objects), (Names{"bunny", "venus", "teapot"}));
  EXPECT_EQ(models.objects[0].mesh->triangles.size(), 20U);
  EXPECT_EQ(models.objects[0].file, "bun_zipper_res4.ply");
  EXPECT_EQ(models.objects[0].title, "Stanford bunny (bun_zipper_res4.ply)");
  EXPECT_EQ(models.objects[0].bytes, fs::file_size(folder.path() / "bun_zipper_res4.ply"));
  EXPECT_FALSE(models.objects[0].stand_in);
  EXPECT_EQ(models.objects[0].trouble, "");
  EXPECT_EQ(models.objects[1].mesh->triangles.size(), 40U);
  EXPECT_TRUE(models.objects[2].stand_in);
  EXPECT_TRUE(holds(models.objects[2].trouble, "teapot.ply is not in "));
}

TEST(Models, ThatAreNotTheOnesOfTheirNameAreRemarkedOn) {
  const Folder folder;
  folder.put("venus.ply", 20);
  const Models models = find_models(folder.path(), kObjects);
  ASSERT_EQ(models.remarks.size(), 1U);
  EXPECT_TRUE(holds(models.remarks[0], "venus.ply does not have the triangles"))
      << models.remarks[0];
}

TEST(Models, HaveBothTeapotsOrOneOrAStandIn) {
  const Folder both;
  both.put("teapot.ply", 20);
  both.put("teapot_1177.ply", 30);
  EXPECT_EQ(names_of(find_models(both.path(), kObjects).objects),
            (Names{"bunny", "venus", "teapot_1177", "teapot"}));
  const Folder small;
  small.put("teapot_1177.ply", 30);
  EXPECT_EQ(names_of(find_models(small.path(), kObjects).objects),
            (Names{"bunny", "venus", "teapot_1177"}));
  const Folder large;
  large.put("teapot.ply", 30);
  EXPECT_EQ(names_of(find_models(large.path(), kObjects).objects),
            (Names{"bunny", "venus", "teapot"}));
  small.put_broken("teapot_1177.ply");
  const Model broken = find_models(small.path(), kObjects).objects[2];
  EXPECT_EQ(broken.name, "teapot_1177");
  EXPECT_EQ(broken.mesh->triangles.size(), 2256U);
}

TEST(Models, ThatCannotBeReadAreNamedWithTheReason) {
  const Folder folder;
  folder.put_broken("bun_zipper_res4.ply");
  fs::create_directory(folder.path() / "venus.ply");
  fs::create_symlink("nowhere", folder.path() / "teapot.ply");
  const Models models = find_models(folder.path(), kObjects);
  EXPECT_TRUE(holds(models.objects[0].trouble, "bun_zipper_res4.ply")) << models.objects[0].trouble;
  EXPECT_FALSE(holds(models.objects[0].trouble, "is not in"));
  EXPECT_TRUE(holds(models.objects[1].trouble, "venus.ply")) << models.objects[1].trouble;
  EXPECT_FALSE(holds(models.objects[1].trouble, "is not in"));
  EXPECT_TRUE(holds(models.objects[2].trouble, "No such file")) << models.objects[2].trouble;
  for (const Model& model : models.objects) {
    EXPECT_TRUE(model.stand_in);
    EXPECT_TRUE(model.file.empty());
  }
}

TEST(Models, TakeTheUsersScenesInPlaceOfTheGenerated) {
  const Folder folder;
  folder.put("town.3ds", 20);
  folder.put("scenes/a.3DS", 30);
  folder.put("scenes/town.3ds", 40);
  folder.put("scenes/bunny.3ds", 50);
  folder.put("3ds/car.3ds", 60);
  const Models models = find_models(folder.path(), kOnlyScenes);
  EXPECT_EQ(names_of(models.scenes), (Names{"town", "a", "bunny_2", "town_2"}));
  EXPECT_EQ(models.scenes[1].title, "a.3DS");
  EXPECT_EQ(models.scenes[1].file, "a.3DS");
  EXPECT_EQ(models.scenes[3].mesh->triangles.size(), 40U);
  EXPECT_TRUE(std::none_of(models.scenes.begin(), models.scenes.end(),
                           [](const Model& model) { return model.stand_in; }));
  EXPECT_TRUE(models.remarks.empty());
}

TEST(Models, LeaveTheFolder3dsAloneAndSaySo) {
  const Folder folder;
  folder.put("3ds/car.3ds", 60);
  const Models models = find_models(folder.path(), kOnlyScenes);
  EXPECT_EQ(names_of(models.scenes), (Names{"u_mixed", "u_boxes", "u_plain"}));
  ASSERT_EQ(models.remarks.size(), 1U);
  EXPECT_TRUE(holds(models.remarks[0], "its .3ds files (1) were not used")) << models.remarks[0];
}

TEST(Models, HaveStandInsForScenesThatCannotBeRead) {
  const Folder folder;
  folder.put_broken("one.3ds");
  folder.put_broken("two.3ds");
  const Models none = find_models(folder.path(), kOnlyScenes);
  EXPECT_EQ(names_of(none.scenes), (Names{"u_mixed", "u_boxes", "u_plain"}));
  for (const Model& scene : none.scenes) {
    EXPECT_TRUE(holds(scene.trouble, "one.3ds")) << scene.trouble;
    EXPECT_TRUE(holds(scene.trouble, "two.3ds")) << scene.trouble;
  }
  folder.put("u_mixed.3ds", 20);
  const Models some = find_models(folder.path(), kOnlyScenes);
  EXPECT_EQ(names_of(some.scenes), (Names{"u_mixed", "u_mixed_2"}));
  EXPECT_EQ(some.scenes[0].trouble, "");
  EXPECT_FALSE(some.scenes[0].stand_in);
  EXPECT_TRUE(holds(some.scenes[1].trouble, "two.3ds"));
  EXPECT_TRUE(some.scenes[1].stand_in);
}

TEST(Models, FindCitiesBySizeAndTellOfThoseThatAreBroken) {
  const Folder folder;
  folder.put("cities/large.ply", 300);
  folder.put("cities/small.PLY", 20);
  folder.put_broken("cities/broken.ply");
  folder.put("elsewhere.ply", 30);
  const Models models = find_models(folder.path(), kCities);
  EXPECT_EQ(names_of(models.cities), (Names{"small", "large"}));
  ASSERT_EQ(models.remarks.size(), 2U);
  EXPECT_TRUE(holds(models.remarks[0], "its other .ply files (1) were not used as cities"))
      << models.remarks[0];
  EXPECT_TRUE(holds(models.remarks[1], "cities that were not used: ")) << models.remarks[1];
  EXPECT_TRUE(holds(models.remarks[1], "broken.ply")) << models.remarks[1];
}

TEST(Models, TakeNoOtherFileForACityWhereThereIsNoFolderOfThem) {
  const Folder folder;
  folder.put("venus.ply", 30);
  EXPECT_TRUE(find_models(folder.path(), kCities).remarks.empty());
  folder.put("town.ply", 20);
  const Models models = find_models(folder.path(), kCities);
  EXPECT_TRUE(models.cities.empty());
  ASSERT_EQ(models.remarks.size(), 1U);
  EXPECT_TRUE(holds(models.remarks[0], "cities are read from its folder cities"))
      << models.remarks[0];
}

TEST(Models, WantAFolder) {
  const Folder folder;
  folder.put("town.ply", 20);
  for (const char* name : {"town.ply", "missing"}) {
    try {
      static_cast<void>(find_models(folder.path() / name, kObjects));
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::cannot_open);
      EXPECT_TRUE(holds(error.what(), name)) << error.what();
    }
  }
}

TEST(Models, TellProgressAndStopWhenRequested) {
  std::vector<double> shares;
  static_cast<void>(
      find_models({}, kAll, {.progress = [&](double share) { shares.push_back(share); }}));
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.size(), 3U);
  EXPECT_EQ(shares.back(), 1);

  const Folder folder;
  folder.put("bun_zipper_res4.ply", 1000);
  std::stop_source stop;
  const Limits stopped{.stop = stop.get_token(), .progress = [&](double) { stop.request_stop(); }};
  EXPECT_THROW(static_cast<void>(find_models(folder.path(), kAll, stopped)), Error);
  EXPECT_THROW(static_cast<void>(find_models({}, {}, stopped)), Error);
}

TEST(Models, OfTheThesisHaveTheHashesOfTheGoldenTables) {
  SOMS_NEEDS_OUTSIDE_DATA("4 models and the cities");
  const Models models = find_models(*test::outside_data(""), kAll);
  EXPECT_EQ(names_of(models.objects), (Names{"bunny", "venus", "teapot_1177", "teapot"}));
  const std::vector<std::uint64_t> hashes{0x23e1390559ce62edULL, 0xb4c5b8d4374d26cdULL,
                                          0x443d997a2f94d83aULL, 0x3d13e5f55250fafcULL};
  for (std::size_t i = 0; i < hashes.size(); ++i) {
    EXPECT_EQ(models.objects[i].hash, hashes[i]);
    EXPECT_FALSE(models.objects[i].stand_in);
  }
  EXPECT_EQ(names_of(models.scenes), (Names{"u_mixed", "u_boxes", "u_plain"}));
  EXPECT_GT(models.cities.size(), 10U);
  ASSERT_EQ(models.remarks.size(), 1U);
  EXPECT_TRUE(holds(models.remarks[0], ".3ds files (19) were not used")) << models.remarks[0];
}

TEST(FitDrives, MakesTheOthersAsLongAsTheFirstAboveTheSamePlace) {
  const Models models = find_models({}, {.objects = true});
  ASSERT_EQ(models.objects.size(), 3U);
  EXPECT_EQ(models.objects[0].drive, DriveFit{});
  const Box goal = bounds(driven(models.objects[0]));
  for (const Model& object : models.objects) {
    const Box own = bounds(driven(object));
    const auto longest = [](const Box& box) {
      return std::max({box.extent().x, box.extent().y, box.extent().z});
    };
    EXPECT_NEAR(longest(own), longest(goal), 1e-9 * longest(goal)) << object.name;
    EXPECT_NEAR(own.lower.z, goal.lower.z, 1e-9 * longest(goal)) << object.name;
    EXPECT_NEAR(own.lower.x + own.upper.x, goal.lower.x + goal.upper.x, 1e-9 * longest(goal));
    EXPECT_NEAR(own.lower.y + own.upper.y, goal.lower.y + goal.upper.y, 1e-9 * longest(goal));
  }
}

TEST(FitDrives, LeavesObjectsWithoutTrianglesAsTheyAre) {
  Models models = find_models({}, {.objects = true});
  models.objects[1].drive = {};
  models.objects[1].mesh = std::make_shared<const Mesh>();
  fit_drives(models.objects);
  EXPECT_EQ(models.objects[1].drive, DriveFit{});
}

}  // namespace
}  // namespace soms::reproduce
