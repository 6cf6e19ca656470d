#include "tests/tree/inputs.h"

#include <cmath>

namespace soms::test {

namespace {

Vec3 point(Rng& rng, double size) {
  const double x = rng.uniform(-size, size);
  const double y = rng.uniform(-size, size);
  const double z = rng.uniform(-size, size);
  return {x, y, z};
}

Triangle near(Rng& rng, const Vec3& center, double size) {
  const Vec3 a = center + point(rng, size);
  const Vec3 b = center + point(rng, size);
  const Vec3 c = center + point(rng, size);
  return {a, b, c};
}

Triangle make(Input input, std::size_t i, Rng& rng) {
  const auto k = static_cast<double>(i);
  switch (input) {
    case Input::random:
      return near(rng, point(rng, 100), 1);
    case Input::coincident:
      return {{1, 2, 3}, {4, 2, 3}, {1, 5, 3}};
    case Input::coplanar: {
      const double x = static_cast<double>(i % 37);
      const double y = std::floor(static_cast<double>(i) / 37);
      return {{x, y, 0}, {x + 1, y, 0}, {x, y + 1, 0}};
    }
    case Input::sliver: {
      const Vec3 a = point(rng, 50);
      const Vec3 far = a + Vec3{40, 40, 40};
      return {a, far, far + point(rng, 1e-9)};
    }
    case Input::huge_and_tiny: {
      const double size = std::ldexp(1.0, static_cast<int>(rng.below(591)) - 300);
      return near(rng, point(rng, size), size * 0.25);
    }
    case Input::nested: {
      const double r = 1 + k;
      return {{-r, -r, 0}, {r, -r, 0}, {0, r, 0}};
    }
    case Input::halving: {
      const double s = std::ldexp(1.0, -static_cast<int>(i % 1001));
      return {{s, 0, 0}, {s, s, 0}, {s, 0, s}};
    }
    case Input::points: {
      const Vec3 p = point(rng, 10);
      return {p, p, p};
    }
  }
  return {};
}

}  // namespace

std::string name(Input input) {
  constexpr std::array<const char*, 8> kNames{"random",        "coincident", "coplanar", "sliver",
                                              "huge_and_tiny", "nested",     "halving",  "points"};
  return kNames[static_cast<std::size_t>(input)];
}

Mesh make_input(Input input, std::size_t count, std::uint64_t seed) {
  Rng rng(seed);
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    const Triangle t = make(input, i, rng);
    const auto v = static_cast<std::uint32_t>(3 * i);
    mesh.vertices.insert(mesh.vertices.end(), {t.a, t.b, t.c});
    mesh.triangles.push_back({v, v + 1, v + 2});
  }
  return mesh;
}

}  // namespace soms::test
