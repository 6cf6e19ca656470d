// Cities that stand somewhere, from files, and a mover on their streets.
#include "soms/io/read_mesh.h"
#include "soms/query/overlap.h"

#include "bench/peers/scenarios/grazing.h"
#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace soms::bench {

namespace {

Box city_bounds(const MeshView& mesh) {
  Box box;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    box.grow(bounds(mesh.triangle(i)));
  }
  return box;
}

/// Height of a triangle over (x, y), or infinity where it does not cover that point.
double height_at(const Triangle& t, double x, double y) {
  const Vec3 u = t.b - t.a;
  const Vec3 v = t.c - t.a;
  const double area = u.x * v.y - u.y * v.x;
  const double s = ((x - t.a.x) * v.y - (y - t.a.y) * v.x) / area;
  const double r = (u.x * (y - t.a.y) - u.y * (x - t.a.x)) / area;
  const bool covers = area != 0 && s >= 0 && r >= 0 && s + r <= 1;
  return covers ? t.a.z + s * u.z + r * v.z : std::numeric_limits<double>::infinity();
}

double lowest_surface(const MeshView& mesh, double x, double y, double otherwise) {
  double lowest = std::numeric_limits<double>::infinity();
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    lowest = std::min(lowest, height_at(mesh.triangle(i), x, y));
  }
  return std::isfinite(lowest) ? lowest : otherwise;
}

/// A way from a random place until the mover touches.
struct Drive {
  Pose start;
  Vec3 ahead;
  double way = 0;   ///< how far it is free
  double into = 0;  ///< how much farther a grazing pose goes
};

/// A city and what drives in it, about the middle of the city and about the mover's own origin.
class CityAndMover {
 public:
  CityAndMover(const std::filesystem::path& city, const std::filesystem::path& mover, double scale)
      : CityAndMover(read_mesh(city), read_mesh(mover), scale) {}

  /// Random places on the lowest surface, 0.1 m above it, turned at random.
  [[nodiscard]] std::vector<Pose> on_streets(Rng rng) const {
    const MeshView& mesh = town_.shape.mesh();
    const Box ground = city_bounds(mesh);
    const double wheels = city_bounds(car_.shape.mesh()).lower.z;
    std::vector<Pose> poses;
    for (std::size_t i = 0; i < kPoses; ++i) {
      const double x = rng.uniform(ground.lower.x, ground.upper.x);
      const double y = rng.uniform(ground.lower.y, ground.upper.y);
      const double z = lowest_surface(mesh, x, y, ground.lower.z);
      poses.push_back(Pose::about_z(rng.uniform(0, 2 * kPi), {x, y, z - wheels + 0.1}));
    }
    return poses;
  }

  /// Drives from these places in random directions; those that are more than 0.01 m and at most
  /// 40 m free go to `use`.
  template <class Use>
  void drive(const std::vector<Pose>& starts, Rng& rng, const Use& use) {
    std::size_t found = 0;
    for (std::size_t k = 0; k < 20 * kPoses && found < kPoses; ++k) {
      const Pose& start = starts[k % starts.size()];
      const double a = rng.uniform(0, 2 * kPi);
      const Vec3 ahead{std::cos(a), std::sin(a), 0};
      const auto touches = [&](double way) {
        car_.pose = onward(start, ahead, way);
        return overlap(car_, town_, {.mode = OverlapMode::any}).any;
      };
      const std::optional<double> way = free_way(touches, {.step = 0.5, .reach = 40});
      const double into = rng.uniform(0.001, 0.05);
      if (way && *way > 0.01) {
        use(Drive{start, ahead, *way, into});
        ++found;
      }
    }
  }

  [[nodiscard]] const FloatMesh& city() const { return fixed_; }

  [[nodiscard]] const FloatMesh& mover() const { return moving_; }

 private:
  CityAndMover(const Mesh& city, const Mesh& mover, double scale)
      : fixed_(float_mesh(city, city_bounds(city).center())),
        moving_(float_mesh(mover, {}, scale)),
        town_(widened(fixed_)),
        car_(widened(moving_)) {}

  FloatMesh fixed_;
  FloatMesh moving_;
  Body town_;
  Body car_;
};

}  // namespace

FloatMesh float_mesh(const Mesh& mesh, const Vec3& middle, double scale) {
  FloatMesh result;
  for (const Vec3& v : mesh.vertices) {
    result.vertices.push_back(narrow(scale * (v - middle)));
  }
  result.triangles = mesh.triangles;
  return result;
}

Scene real_city_scene(const std::string& name, const std::filesystem::path& city,
                      const std::filesystem::path& mover, std::uint64_t seed) {
  CityAndMover bodies(city, mover, 1);
  Scene scene{name,
              bodies.mover(),
              bodies.city(),
              {{"street", bodies.on_streets(rng_of(31, seed)), kNear},
               {"grazing", {}},
               {"near", {}, kNear}}};
  Rng rng = rng_of(32, seed);
  bodies.drive(scene.sets[0].poses, rng, [&](const Drive& drive) {
    scene.sets[1].poses.push_back(onward(drive.start, drive.ahead, drive.way + drive.into));
    scene.sets[2].poses.push_back(onward(drive.start, drive.ahead, drive.way - 0.01));
  });
  return scene;
}

Scene unlike_city_scene(const std::string& name, const std::filesystem::path& city,
                        const std::filesystem::path& mover, double scale, std::uint64_t seed) {
  CityAndMover bodies(city, mover, scale);
  Scene scene{
      name,
      bodies.mover(),
      bodies.city(),
      {{"random", bodies.on_streets(rng_of(33, seed)), kAnyAndAll}, {"grazing", {}, kAnyAndAll}}};
  Rng rng = rng_of(34, seed);
  bodies.drive(scene.sets[0].poses, rng, [&](const Drive& drive) {
    scene.sets[1].poses.push_back(onward(drive.start, drive.ahead, drive.way + drive.into));
  });
  return scene;
}

}  // namespace soms::bench
