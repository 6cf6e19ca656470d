#include "bench/peers/scenarios/solids.h"

namespace soms::bench {

FloatMesh referee_car() {
  FloatMesh mesh = ellipsoid({0, 0, 0.825}, {2.25, 0.85, 0.625}, 24, 15, 0.5);
  for (const double x : {-1.35, 1.35}) {
    for (const double y : {-0.75, 0.75}) {
      append(mesh, cylinder({x, y, 0.32}, {0, 1, 0}, 0.32, 0.1, 16));
    }
  }
  for (const double y : {-0.875, 0.875}) {
    append(mesh, box({0.7, y, 1.0}, {0.1, 0.1, 0.07}));
  }
  return mesh;
}

FloatMesh referee_drone() {
  FloatMesh mesh = ellipsoid({0, 0, 0}, {0.2, 0.2, 0.08}, 10, 5);
  for (int i = 0; i < 4; ++i) {
    const double a = kPi / 4 + i * kPi / 2;
    append(mesh, box({0.2 * std::cos(a), 0.2 * std::sin(a), 0.02}, {0.18, 0.015, 0.015}, a));
    append(mesh,
           cylinder({0.36 * std::cos(a), 0.36 * std::sin(a), 0.06}, {0, 0, 1}, 0.14, 0.01, 10));
  }
  return mesh;
}

}  // namespace soms::bench
