#include "soms/generate/urban.h"

#include "soms/base/arithmetic.h"

#include <array>
#include <cstdint>
#include <map>
#include <tuple>

namespace soms {

namespace {

constexpr std::size_t kTriangles = 5672;

/// The linear congruential generator that the scenes are defined by.
class Lcg {
 public:
  explicit Lcg(std::uint32_t seed) : state_(seed) {}

  int below(int n) {
    state_ = (1103515245U * state_ + 12345U) & 0x7fffffffU;
    return static_cast<int>((state_ >> 8) % static_cast<std::uint32_t>(n));
  }

 private:
  std::uint32_t state_;
};

/// Collects triangles; equal corners become one vertex.
class Scene {
 public:
  void triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const std::uint32_t i = vertex(a);
    const std::uint32_t j = vertex(b);
    const std::uint32_t k = vertex(c);
    mesh_.triangles.push_back({i, j, k});
  }

  /// Corners around the face.
  void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }

  /// 12 triangles, faces -z +z -y +y -x +x; bits 0, 1, 2 of a corner's number mean x1, y1, z1.
  void box(int x0, int y0, int z0, int x1, int y1, int z1) {
    std::array<Vec3, 8> p;
    for (unsigned i = 0; i < 8; ++i) {
      p[i] = {static_cast<double>((i & 1U) != 0 ? x1 : x0),
              static_cast<double>((i & 2U) != 0 ? y1 : y0),
              static_cast<double>((i & 4U) != 0 ? z1 : z0)};
    }
    quad(p[0], p[2], p[3], p[1]);
    quad(p[4], p[5], p[7], p[6]);
    quad(p[0], p[1], p[5], p[4]);
    quad(p[2], p[6], p[7], p[3]);
    quad(p[0], p[4], p[6], p[2]);
    quad(p[1], p[3], p[7], p[5]);
  }

  void end_part(const char* name) {
    const auto count = static_cast<std::uint32_t>(size());
    mesh_.parts.push_back({name, Part::kNoParent, part_first_, count - part_first_});
    part_first_ = count;
  }

  [[nodiscard]] std::size_t size() const { return mesh_.triangles.size(); }

  Mesh finish(const char* name) {
    mesh_.unit = 1;
    mesh_.up = UpAxis::z;
    mesh_.source = name;
    return std::move(mesh_);
  }

 private:
  std::uint32_t vertex(const Vec3& v) {
    const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto [at, inserted] = numbers_.try_emplace(std::tuple(v.x, v.y, v.z), next);
    if (inserted) {
      mesh_.vertices.push_back(v);
    }
    return at->second;
  }

  Mesh mesh_;
  std::map<std::tuple<double, double, double>, std::uint32_t> numbers_;
  std::uint32_t part_first_ = 0;
};

/// A building of random size on the plot of 180 m at (x, y).
void plot(Scene& scene, Lcg& random, int x, int y) {
  const int width = 40 + random.below(90);
  const int depth = 40 + random.below(90);
  int height = 6 + random.below(30);
  if (random.below(8) == 0) {
    height += random.below(150);
  }
  const int x0 = x + 20 + random.below(150 - width + 1);
  const int y0 = y + 20 + random.below(150 - depth + 1);
  scene.box(x0, y0, 0, x0 + width, y0 + depth, height);
}

Mesh urban_boxes() {
  Scene scene;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const int x = 2000 * (quarter % 2);
    const int y = 2000 * (quarter / 2);
    const double x0 = x;
    const double y0 = y;
    scene.quad({x0, y0, 0}, {x0 + 2000, y0, 0}, {x0 + 2000, y0 + 2000, 0}, {x0, y0 + 2000, 0});
    Lcg random(static_cast<std::uint32_t>(1 + quarter));
    for (int k = 0; k < 118; ++k) {
      plot(scene, random, x + 180 * (k % 11), y + 180 * (k / 11));
    }
  }
  return scene.finish("urban_boxes");
}

Mesh urban_plain() {
  Scene scene;
  Lcg random(5);
  for (int k = 0; k < 472; ++k) {
    plot(scene, random, 180 * (k % 22), 180 * (k / 22));
  }
  const auto pad = [&scene](double x, double y) {
    scene.quad({x, y, -1}, {x + 40, y, -1}, {x + 40, y + 40, -1}, {x, y + 40, -1});
  };
  pad(0, 0);
  pad(3960, 0);
  pad(3960, 3960);
  pad(0, 3960);
  return scene.finish("urban_plain");
}

/// 16 x 16 cells of 250 m, below the city.
void terrain(Scene& scene) {
  Lcg random(7);
  std::array<std::array<double, 17>, 17> height{};
  for (auto& row : height) {
    for (double& h : row) {
      h = -30 + random.below(30);
    }
  }
  for (std::size_t j = 0; j < 16; ++j) {
    for (std::size_t i = 0; i < 16; ++i) {
      const double x = 250.0 * static_cast<double>(i);
      const double y = 250.0 * static_cast<double>(j);
      scene.quad({x, y, height[j][i]}, {x + 250, y, height[j][i + 1]},
                 {x + 250, y + 250, height[j + 1][i + 1]}, {x, y + 250, height[j + 1][i]});
    }
  }
  scene.end_part("terrain");
}

/// 17 roads each way, 4 km long and 12 m wide, one every 244 m.
void roads(Scene& scene) {
  for (int k = 0; k < 17; ++k) {
    const double c = 244 * k + 40;
    scene.quad({c, 0, 0}, {c + 12, 0, 0}, {c + 12, 4000, 0}, {c, 4000, 0});
  }
  for (int k = 0; k < 17; ++k) {
    const double c = 244 * k + 40;
    scene.quad({0, c, 0}, {4000, c, 0}, {4000, c + 12, 0}, {0, c + 12, 0});
  }
  scene.end_part("roads");
}

void tower(Scene& scene, Lcg& random, int x, int y, int width, int depth) {
  const int h = 20 + random.below(60);
  scene.box(x, y, 0, x + width, y + depth, h);
  scene.box(x + width / 4, y + depth / 4, h, x + width - width / 4, y + depth - depth / 4,
            h + 20 + random.below(120));
}

/// 8 wall, 2 gable and 4 roof triangles.
void gabled_house(Scene& scene, Lcg& random, int x, int y, int width, int depth) {
  const double x0 = x;
  const double x1 = x + width;
  const double y0 = y;
  const double y1 = y + depth;
  const double eaves = 4 + random.below(6);
  const double ridge = eaves + (3 + random.below(5));
  const std::array<Vec3, 8> p{{{x0, y0, 0},
                               {x1, y0, 0},
                               {x1, y1, 0},
                               {x0, y1, 0},
                               {x0, y0, eaves},
                               {x1, y0, eaves},
                               {x1, y1, eaves},
                               {x0, y1, eaves}}};
  const Vec3 e{x0, y0 + depth / 2.0, ridge};
  const Vec3 f{x1, y0 + depth / 2.0, ridge};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t next = (k + 1) % 4;
    scene.quad(p[k], p[next], p[4 + next], p[4 + k]);
  }
  scene.triangle(p[4], e, p[7]);
  scene.triangle(p[5], p[6], f);
  scene.quad(p[4], p[5], f, e);
  scene.quad(p[7], e, f, p[6]);
}

/// One thing in each of the 16 x 16 blocks between the roads.
void blocks(Scene& scene, Lcg& random) {
  for (int block = 0; block < 256; ++block) {
    const int kind = random.below(10);
    const int width = 30 + random.below(110);
    const int depth = 30 + random.below(110);
    const int x = 244 * (block % 16) + 60 + random.below(210 - width);
    const int y = 244 * (block / 16) + 60 + random.below(210 - depth);
    if (kind < 6) {
      scene.box(x, y, 0, x + width, y + depth, 5 + random.below(40));
    } else if (kind < 8) {
      tower(scene, random, x, y, width, depth);
    } else {
      gabled_house(scene, random, x, y, width, depth);
    }
  }
  scene.end_part("blocks");
}

/// Upright signs of 2 m beside the roads, as many as are left.
void signs(Scene& scene, Lcg& random) {
  while (scene.size() < kTriangles) {
    const double road = 244 * random.below(17) + 54;
    const double along = random.below(3950);
    const bool upward = random.below(2) != 0;
    const double x = upward ? road : along;
    const double y = upward ? along : road;
    if (random.below(2) != 0) {
      scene.quad({x, y, 2}, {x + 2, y, 2}, {x + 2, y, 4}, {x, y, 4});
    } else {
      scene.quad({x, y, 2}, {x, y + 2, 2}, {x, y + 2, 4}, {x, y, 4});
    }
  }
  scene.end_part("signs");
}

Mesh urban_mixed() {
  Scene scene;
  terrain(scene);
  roads(scene);
  Lcg random(11);
  blocks(scene, random);
  signs(scene, random);
  return scene.finish("urban_mixed");
}

}  // namespace

Mesh generate_urban(UrbanScene scene) {
  const PlainArithmetic plain;
  switch (scene) {
    case UrbanScene::mixed:
      return urban_mixed();
    case UrbanScene::boxes:
      return urban_boxes();
    case UrbanScene::plain:
      return urban_plain();
  }
  return {};
}

}  // namespace soms
