// A body against its twin, at any angle.
#include "soms/query/distance.h"
#include "soms/query/overlap.h"

#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

#include <optional>
#include <utility>

namespace soms::bench {

namespace {

Pose shifted(Pose pose, const Vec3& t) {
  pose.m[3] = t.x;
  pose.m[7] = t.y;
  pose.m[11] = t.z;
  return pose;
}

/// Finds poses that leave a gap. soms says where sliding stops and how far apart the bodies are;
/// the judge, who has no tree, decides every answer about them.
class NearMisses {
 public:
  explicit NearMisses(const FloatMesh& mesh) : twin_(widened(mesh)), body_(twin_) {}

  /// `count` poses at which the bodies are `gap` apart, to 2 %.
  [[nodiscard]] std::vector<Pose> find(double gap, std::size_t count, Rng rng) {
    std::vector<Pose> poses;
    while (poses.size() < count) {
      const Pose turned = random_rotation(rng, {});
      const Vec3 direction = random_direction(rng);
      const std::optional<Pose> pose = slide(turned, direction, gap);
      if (pose) {
        poses.push_back(*pose);
      }
    }
    return poses;
  }

 private:
  bool touches(const Pose& pose) {
    body_.pose = pose;
    return overlap(body_, twin_, {.mode = OverlapMode::any}).any;
  }

  /// At `s` along the line; 2 gaps where it is more.
  double distance_at(const Pose& turned, const Vec3& direction, double s, double gap) {
    body_.pose = shifted(turned, s * direction);
    const Distance found = distance(body_, twin_, {.at_most = 2 * gap});
    return found.farther ? 2 * gap : found.distance.lower;
  }

  /// In along the line until it touches, then out until the distance is right.
  std::optional<Pose> slide(const Pose& turned, const Vec3& direction, double gap) {
    double touching = 2.5;
    while (touching > -2.5 && !touches(shifted(turned, touching * direction))) {
      touching -= 0.05;
    }
    double close = touching;
    double apart = touching + gap;
    while (apart < 2.5 && distance_at(turned, direction, apart, gap) < gap) {
      close = apart;
      apart += apart - touching;
    }
    for (int i = 0; i < 40 && touching > -2.5; ++i) {
      const double middle = 0.5 * (close + apart);
      const double left = distance_at(turned, direction, middle, gap);
      if (std::abs(left - gap) < 0.02 * gap) {
        return shifted(turned, middle * direction);
      }
      (left < gap ? close : apart) = middle;
    }
    return std::nullopt;
  }

  Body twin_;
  Body body_;
};

/// Fewer where a distance takes long.
std::size_t near_misses(std::size_t triangles) {
  return triangles > 200'000 ? 200 : triangles > 20'000 ? 500 : kPoses;
}

Scene twins(const std::string& name, FloatMesh mesh, std::uint64_t seed) {
  const std::size_t n = mesh.triangles.size();
  // Enough of a knot's random poses touch for a question that leaves nothing to be moved.
  const bool still = name == "knot" && n >= 10'000 && n <= 100'000;
  Scene scene{"twins-" + name, mesh, std::move(mesh), {}};
  PoseSet random{"random", {}, kEveryPoseJob, still ? std::size_t{16} : std::size_t{0}};
  PoseSet deep{"deep", {}, {Job::any, Job::all}};
  Rng rng = rng_of(11, seed);
  Rng deep_rng = rng_of(12, seed);
  for (std::size_t i = 0; i < kPoses; ++i) {
    const Pose turned = random_rotation(rng, {});
    random.poses.push_back(shifted(turned, rng.uniform(1.0, 1.9) * random_direction(rng)));
    const Pose inside = random_rotation(deep_rng, {});
    deep.poses.push_back(shifted(inside, deep_rng.uniform(0, 0.2) * random_direction(deep_rng)));
  }
  NearMisses misses(scene.fixed);
  scene.sets = {std::move(random),
                std::move(deep),
                {"near-0.001", misses.find(0.001, near_misses(n), rng_of(13, seed)), kNear},
                {"near-0.01", misses.find(0.01, near_misses(n), rng_of(13, seed)), kNear}};
  if (name == "knot") {  // closed and connected, and never one in the other
    for (PoseSet& set : scene.sets) {
      set.jobs.push_back(Job::solid);
    }
  }
  return scene;
}

}  // namespace

Scene knot_scene(std::uint64_t triangles, std::uint64_t seed) {
  return twins("knot", referee_knot(triangles), seed);
}

Scene far_scene(std::uint64_t triangles, std::uint64_t seed) {
  const FloatMesh knot = referee_knot(triangles);
  Scene scene{"far-knot", knot, knot, {}};
  for (const auto& [name, apart] :
       {std::pair{"far-3", 3.0}, {"far-300", 300.0}, {"far-3e4", 3e4}, {"far-3e5", 3e5}}) {
    PoseSet set{name, {}, {Job::distance, Job::within}};
    Rng rng = rng_of(14, seed);
    for (std::size_t i = 0; i < kPoses; ++i) {
      const Pose turned = random_rotation(rng, {});
      set.poses.push_back(shifted(turned, apart * random_direction(rng)));
    }
    scene.sets.push_back(std::move(set));
  }
  return scene;
}

Scene model_scene(const std::filesystem::path& file, std::uint64_t seed) {
  return twins(file.stem().string(), unit_model(file), seed);
}

}  // namespace soms::bench
