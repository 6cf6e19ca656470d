// The drive that touches: chosen by counts, the same on every machine, for any scene.
#include "thesis/races/touching_drive.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/query/reference/overlap.h"
#include "soms/thesis/thesis_frames.h"

#include "tests/reproduce/trips.h"
#include "tests/support/support.h"

#include <algorithm>
#include <map>
#include <memory>
#include <stop_token>
#include <string>

namespace soms::reproduce {
namespace {

/// A knot that is about as large as the bunny.
Model small_knot() {
  Model knot;
  knot.name = "knot";
  knot.mesh = std::make_shared<const Mesh>(transformed(generate_knot(300), 0.06, UpAxis::z));
  return knot;
}

Model scene_of(Mesh mesh) {
  Model scene;
  scene.name = "scene";
  scene.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return scene;
}

using FrameCounts = std::map<std::string, std::size_t>;

/// Contact frames of the drives through the generated scenes, each also counted on SOMS trees.
FrameCounts contact_frames(const Model& object) {
  const std::vector<Contender> of_object = thesis_rules(kObjectLevel);
  const std::vector<Contender> of_scene = thesis_rules(kSceneLevel);
  FrameCounts counts;
  for (const Model& scene : find_models({}, {.scenes = true}).scenes) {
    const TouchingDrive drive = find_touching_drive(scene, object);
    EXPECT_EQ(drive.offsets.size(), city_drive().size());
    EXPECT_EQ(drive.lines, 128U);
    counts[scene.name] = drive.contact_frames;
    const Trip trip = touching_drive_trip(scene, object, of_scene.back(), of_object.back(), drive);
    EXPECT_EQ(trip.test, "touching_drive");
    const std::vector<Frame> frames = answer_frames(trip, named_traversal("larger"), {});
    EXPECT_EQ(std::count_if(frames.begin(), frames.end(),
                            [](const Frame& frame) { return !frame.contacts.empty(); }),
              static_cast<std::ptrdiff_t>(drive.contact_frames))
        << scene.name;
  }
  return counts;
}

TEST(TouchingDrive, TouchesInGoldenNumbersOfFrames) {
  EXPECT_EQ(contact_frames(small_knot()),
            (FrameCounts{{"u_mixed", 67}, {"u_boxes", 76}, {"u_plain", 119}}));
}

TEST(TouchingDrive, TouchesInGoldenNumbersOfFramesWithTheBunny) {
  SOMS_NEEDS_OUTSIDE_DATA("contact frames of the bunny's touching drives");
  const Models models = find_models(*soms::test::outside_data(""), {.objects = true});
  EXPECT_EQ(contact_frames(models.objects.front()),
            (FrameCounts{{"u_mixed", 105}, {"u_boxes", 113}, {"u_plain", 106}}));
}

TEST(TouchingDrive, CountsWhatBruteForceFinds) {
  const Models models = trips::small_models();
  const Model& object = models.objects.front();
  const Mesh mover = driven(object);
  const TouchingDrive drive = find_touching_drive(models.scenes.front(), object);
  std::size_t touching = 0;
  for (const Vec3& by : drive.offsets) {
    touching += reference::overlap(*models.scenes.front().mesh, Pose::identity(), mover,
                                   Pose::translation(by.x, by.y, by.z))
                        .pairs.empty()
                    ? 0U
                    : 1U;
  }
  EXPECT_GT(touching, 0U);
  EXPECT_LT(touching, drive.offsets.size());
  EXPECT_EQ(drive.contact_frames, touching);
}

TEST(TouchingDrive, FollowsTheSceneWhereverItIs) {
  const Models models = trips::small_models();
  Mesh away = *models.scenes.front().mesh;
  for (Vec3& v : away.vertices) {
    v += {0, 65536, 4096};
  }
  const TouchingDrive here = find_touching_drive(models.scenes.front(), models.objects.front());
  const TouchingDrive there = find_touching_drive(scene_of(away), models.objects.front());
  EXPECT_GT(there.contact_frames, 0U);
  EXPECT_EQ(there.touching_lines, here.touching_lines);
}

TEST(TouchingDrive, SaysWhereNothingCanBeTouched) {
  // Two specks at the corners of a large empty box, away from all lines.
  Mesh specks;
  specks.vertices = {{0, 0, 0},
                     {1, 0, 0},
                     {0, 1, 0},
                     {90000, 90000, 90000},
                     {90001, 90000, 90000},
                     {90000, 90001, 90000}};
  specks.triangles = {{0, 1, 2}, {3, 4, 5}};
  for (const Mesh& mesh : {specks, Mesh{}}) {
    const Model scene = scene_of(mesh);
    const TouchingDrive drive = find_touching_drive(scene, small_knot());
    EXPECT_EQ(drive.contact_frames, 0U);
    EXPECT_EQ(drive.touching_lines, 0U);
    EXPECT_EQ(drive.offsets.size(), city_drive().size());
    EXPECT_NE(touching_drive_remark(scene, small_knot(), drive).find("has no contact frames"),
              std::string::npos);
  }
}

TEST(TouchingDrive, EndsOnRequest) {
  const Models models = trips::small_models();
  std::stop_source source;
  source.request_stop();
  try {
    (void)find_touching_drive(models.scenes.front(), models.objects.front(),
                              {.stop = source.get_token()});
    ADD_FAILURE() << "went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cancelled);
  }
}

}  // namespace
}  // namespace soms::reproduce
