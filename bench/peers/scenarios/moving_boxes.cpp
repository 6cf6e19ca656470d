// Boxes that all move, frame by frame.
#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

#include <cmath>

namespace soms::bench {

namespace {

constexpr std::size_t kFrames = 20;
constexpr double kFramesASecond = 60;

enum class Spacing { spread, dense, mixed };

struct Mover {
  Vec3 center;
  Vec3 half;
  Vec3 step;  // a frame
};

Vec3 random_sides(Spacing spacing, Rng& rng) {
  // Mixed: a Pareto law, 1 to 100 m, half of them below 1.4 m.
  const double scale = spacing == Spacing::mixed ? 1 / std::sqrt(rng.uniform(1e-4, 1)) : 1;
  const double least = 0.5;
  const double most = spacing == Spacing::mixed ? 1 : 2.25;
  const double x = scale * rng.uniform(least, most);
  const double y = scale * rng.uniform(least, most);
  return {x, y, scale * rng.uniform(least, most)};
}

Vec3 room_for(Spacing spacing, double boxes) {
  switch (spacing) {
    case Spacing::spread:
      return {4000, 4000, 100};
    case Spacing::dense: {
      // Two boxes meet where their centers are within the sum of their halves, 5.5 m on the mean.
      const double side = std::cbrt(boxes * 5.5 * 5.5 * 5.5 / 10);
      return {side, side, side};
    }
    case Spacing::mixed:
      break;
  }
  return {10 * std::sqrt(boxes), 10 * std::sqrt(boxes), 100};
}

MovingBoxSet moving_boxes(const std::string& name, Spacing spacing, std::uint64_t boxes,
                          std::uint64_t seed) {
  Rng rng = rng_of(41 + boxes, seed);
  const Vec3 room = room_for(spacing, static_cast<double>(boxes));
  std::vector<Mover> movers(boxes);
  for (Mover& m : movers) {
    const double x = rng.uniform(0, room.x);
    const double y = rng.uniform(0, room.y);
    m.center = {x, y, rng.uniform(0, room.z)};
    m.half = random_sides(spacing, rng);
    const double speed = rng.uniform(0, 20);
    m.step = (speed / kFramesASecond) * random_direction(rng);
  }
  MovingBoxSet set{name, {}};
  for (std::size_t frame = 0; frame < kFrames; ++frame) {
    std::vector<FloatBox>& now = set.frames.emplace_back();
    for (Mover& m : movers) {
      now.push_back({narrow(m.center - m.half), narrow(m.center + m.half)});
      m.center += m.step;
    }
  }
  return set;
}

}  // namespace

Scene moving_boxes_scene(std::uint64_t boxes, std::uint64_t seed) {
  return {"moving-boxes",
          {},
          {},
          {},
          {moving_boxes("spread", Spacing::spread, boxes, seed),
           moving_boxes("dense", Spacing::dense, boxes, seed),
           moving_boxes("mixed", Spacing::mixed, boxes, seed)}};
}

}  // namespace soms::bench
