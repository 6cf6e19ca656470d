// Models that stand on y are distinguished from those that stand on z, by their shape.
#include "apps/model/up_guess.h"

#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/generate/statue.h"
#include "soms/io/read_mesh.h"

#include "tests/commands/run.h"

#include <string>

namespace soms::command {
namespace {

/// A mesh that stands on z, standing on y.
Mesh on_y(Mesh mesh) {
  for (Vec3& v : mesh.vertices) {
    v = {v.x, v.z, -v.y};
  }
  return mesh;
}

TEST(UpGuess, FindsMoversThatStandOnY) {
  for (const MoverKind kind : {MoverKind::car, MoverKind::person}) {
    EXPECT_FALSE(looks_y_up(generate_mover(kind)));
    EXPECT_TRUE(looks_y_up(on_y(generate_mover(kind))));
  }
}

TEST(UpGuess, FindsAStatueThatStandsOnY) {
  EXPECT_FALSE(looks_y_up(generate_statue(5000)));
  EXPECT_TRUE(looks_y_up(on_y(generate_statue(5000))));
}

TEST(UpGuess, LeavesCitiesOnHillsAsTheyAre) {
  const Mesh city = generate_city({.triangles = 5000}).mesh;
  EXPECT_FALSE(looks_y_up(city));
}

TEST(UpGuess, IsSilentOfWhatHasNoShape) {
  EXPECT_FALSE(looks_y_up(Mesh{}));
  Mesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  flat.triangles = {{0, 1, 2}};
  EXPECT_FALSE(looks_y_up(flat));
  EXPECT_FALSE(looks_y_up(on_y(flat)));
}

TEST(UpGuess, IsRightAboutModelsOfOthers) {
  SOMS_NEEDS_OUTSIDE_DATA("35 models of others");
  for (const char* const name :
       {"ply/beethoven.ply", "ply/big_dodge.ply", "ply/big_porsche.ply", "ply/bun_zipper_res2.ply",
        "ply/cow.ply", "ply/dragon_vrip_res3.ply", "ply/street_lamp.ply", "ply/teapot.ply",
        "ply/venus.ply", "other/beetle.off", "other/horse_quad.obj", "other/teapot.obj"}) {
    EXPECT_TRUE(looks_y_up(read_mesh(*test::outside_data(name)))) << name;
  }
  for (const char* const name : {"ply/dolphins.ply",
                                 "ply/f16.ply",
                                 "ply/galleon.ply",
                                 "ply/hind.ply",
                                 "ply/octagonal_pocket.ply",
                                 "ply/pickup_big.ply",
                                 "ply/vw.ply",
                                 "ply/teapot_1177.ply",
                                 "ply/fuze.ply",
                                 "other/Spider_binary.stl",
                                 "other/featuretype.STL",
                                 "3ds/car_disim.3ds",
                                 "3ds/chairs.3ds",
                                 "3ds/jeep1.3ds",
                                 "3ds/land.3ds",
                                 "3ds/lecture_hall.3ds",
                                 "3ds/truck_disim.3ds",
                                 "3ds/van_disim.3ds",
                                 "cities/delft.ply",
                                 "cities/lyon.ply",
                                 "cities/munich_tum.ply",
                                 "cities/new_york_mid.ply",
                                 "cities/zurich_subset.ply"}) {
    EXPECT_FALSE(looks_y_up(read_mesh(*test::outside_data(name)))) << name;
  }
}

}  // namespace
}  // namespace soms::command
