/// \file
/// What libraries are queried about: two meshes and sets of poses, or boxes that move. All seeded.
#pragma once

#include "soms/base/random.h"
#include "soms/geometry/frames.h"
#include "soms/geometry/mesh.h"

#include "bench/peers/libraries/library.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace soms::bench {

struct PoseSet {
  std::string name;
  std::vector<Pose> poses;
  std::vector<Job> jobs{Job::any};
  std::size_t still = 0;  ///< so many poses are queried of bodies that stand still, too
};

/// Frames of one set of moving boxes.
struct MovingBoxSet {
  std::string name;
  std::vector<std::vector<FloatBox>> frames;
};

/// Points or rays, with numbers that are floats, and what they are queried for.
struct ProbeSet {
  std::string name;
  std::vector<Vec3> points = {};
  std::vector<ProbeRay> rays = {};
  std::vector<Job> jobs = {};
};

/// One mover, one body that stands still, and where the mover is in each query; or what probes a
/// body; or sets of moving boxes.
struct Scene {
  std::string name;
  FloatMesh mover;
  FloatMesh fixed;
  std::vector<PoseSet> sets;
  std::vector<MovingBoxSet> moving_sets = {};
  std::vector<ProbeSet> probe_sets = {};
  /// Of an arm, in place of `mover`. Its sets have a pose for each link, in turn.
  std::vector<FloatMesh> links = {};
  std::vector<FrameDoubt> doubts = {};     ///< of files whose numbers may not mean the same
  std::vector<std::string> warnings = {};  ///< these in words, and notes of the files
};

inline constexpr std::size_t kPoses = 1000;

/// The random numbers of a set. Seed 1 gives those of all results so far.
[[nodiscard]] inline Rng rng_of(std::uint64_t set, std::uint64_t seed) {
  return Rng(((seed - 1) << 32U) + set);
}

/// Does it touch, how far is it, is it within a clearance?
inline const std::vector<Job> kNear{Job::any, Job::distance, Job::within};
inline const std::vector<Job> kAnyAndAll{Job::any, Job::all};
inline const std::vector<Job> kEveryPoseJob{Job::any, Job::all, Job::distance, Job::within};

/// `twins-knot`: a (2,3) torus knot of reach 1 against its twin at the origin. `random`: any
/// rotation, centers 1.0 to 1.9 apart, where about half touch; `near-0.001`, `near-0.01`: slid
/// together until that distance is left, to 2 %; `deep`: centers within 0.2.
[[nodiscard]] Scene knot_scene(std::uint64_t triangles, std::uint64_t seed);

/// `twins-<model>`: a model of a file, scaled to reach 1 about the middle of its box, likewise.
[[nodiscard]] Scene model_scene(const std::filesystem::path& file, std::uint64_t seed);

/// `city-car`: the referee's city, 4 km of hills, streets 16 m wide every 100 m, boxes; a car of
/// 1,000 triangles 0.1 m above the highest ground under it: `car` anywhere on the streets, 15 %
/// beside a wall from 0.1 m inside to 0.3 m off; `car-path` one drive of 0.2 m a pose with turns.
[[nodiscard]] Scene city_car_scene(std::uint64_t triangles, std::uint64_t seed);

/// `city-drone`: the same city and a drone of 308 triangles, 2 to 40 m up, any rotation, 15 %
/// beside a wall; and one flight, `drone-path`.
[[nodiscard]] Scene city_drone_scene(std::uint64_t triangles, std::uint64_t seed);

/// `streets`: the city of `soms generate` and its car on its street routes: 50 cars, 20 poses each,
/// half a second apart. Its road slabs are large and slope under the car.
[[nodiscard]] Scene street_scene(std::uint64_t triangles, std::uint64_t seed);

/// `name`: a city of a file and a mover of another. `street`: 1,000 random places on the
/// lowest surface, 0.1 m above it; `grazing`: from there forward until it touches and up to 0.05 m
/// on; `near`: forward until 0.01 m more would touch.
[[nodiscard]] Scene real_city_scene(const std::string& name, const std::filesystem::path& city,
                                    const std::filesystem::path& mover, std::uint64_t seed);

/// `unlike-<mover>-<city>`: the same two sets for bodies that no figure was made for, `random` and
/// `grazing`. The mover's coordinates are multiplied by `scale`, which makes them meters.
[[nodiscard]] Scene unlike_city_scene(const std::string& name, const std::filesystem::path& city,
                                      const std::filesystem::path& mover, double scale,
                                      std::uint64_t seed);

/// `unlike-<mover>-<fixed>`: two models, each scaled to reach 1. `random`: any rotation, centers up
/// to 2 apart; `grazing`: slid toward a random point of the middle until they touch and 0.0001 to
/// 0.005 on.
[[nodiscard]] Scene unlike_models_scene(const std::string& name, const std::filesystem::path& mover,
                                        const std::filesystem::path& fixed, std::uint64_t seed);

/// `unlike-chairs-hall`: a row of chairs in a hall, whose coordinates `scale` makes meters.
/// `random`: upright, anywhere in the hall's box; `grazing`: pushed along the floor until it
/// touches and 1 to 50 mm on.
[[nodiscard]] Scene unlike_hall_scene(const std::string& name, const std::filesystem::path& mover,
                                      const std::filesystem::path& fixed, double scale,
                                      std::uint64_t seed);

/// `unlike-arm-cell`: an arm of six links in a generated cell of about 300,000 triangles. `random`:
/// any angles of the joints; `grazing`: joints turned at random rates until a link touches and 0.5
/// to 25 mrad on.
[[nodiscard]] Scene arm_scene(std::uint64_t seed);

/// `far-knot`: the knot and its twin, far apart: `far-3`, `far-300`, `far-3e4` and `far-3e5`, any
/// rotation, centers so many reaches apart.
[[nodiscard]] Scene far_scene(std::uint64_t triangles, std::uint64_t seed);

/// `probe-<body>`: 20,000 points and rays at a closed body of a mesh, or at the referee's city,
/// which is open and not queried for `contains`. `random`: points anywhere in its box and a tenth
/// around it; `near`: within a thousandth of its size of a triangle; `path`: one after the other
/// along a curve; `rays`: from such random points, in any direction; `camera`: through the lines of
/// a picture of it.
[[nodiscard]] Scene knot_probes(std::uint64_t triangles, std::uint64_t seed);
[[nodiscard]] Scene city_probes(std::uint64_t triangles, std::uint64_t seed);
[[nodiscard]] Scene model_probes(const std::filesystem::path& file, std::uint64_t seed);

/// `moving_boxes`: boxes, 20 frames at 60 a second, up to 20 m/s. `spread`: sides of 1 to 4.5 m in
/// 4 km x 4 km x 100 m; `dense`: the same where each meets about ten others; `mixed`: sides of 1 to
/// 200 m, most of them small, 100 boxes to the hectare.
[[nodiscard]] Scene moving_boxes_scene(std::uint64_t boxes, std::uint64_t seed);

/// `own`: two meshes of files. Both are moved to float coordinates about their middles, which the
/// poses make up for; without poses, `random` ones that put A anywhere about B's box. With `strict`
/// the files are read so, and a doubt about their frames is an error.
/// \errors As `read_mesh`; ErrorKind::bad_file.
[[nodiscard]] Scene own_files_scene(const std::filesystem::path& a, const std::filesystem::path& b,
                                    const std::vector<Pose>& poses, std::size_t random,
                                    std::uint64_t seed, bool strict);

/// Reads a mesh; `middle` is taken off each vertex before it is rounded to floats.
[[nodiscard]] FloatMesh float_mesh(const Mesh& mesh, const Vec3& middle, double scale = 1);

/// A model of a file, scaled to reach 1 about the middle of its box. \errors As `read_mesh`.
[[nodiscard]] FloatMesh unit_model(const std::filesystem::path& file);

}  // namespace soms::bench
