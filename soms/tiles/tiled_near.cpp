// How far is a mover from tiles, and is it within a clearance of them?
#include "soms/base/arithmetic.h"
#include "soms/describe/columns.h"
#include "soms/geometry/detail/pair_distance.h"
#include "soms/motion/detail/moved_bounds.h"
#include "soms/query/detail/check_options.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/scene/detail/box_bounds.h"
#include "soms/tiles/detail/nearest_tile.h"
#include "soms/tiles/tiled_queries.h"

#include <algorithm>
#include <compare>
#include <limits>

namespace soms {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How far is a body?
class BodyQuestion {
 public:
  using Answer = Distance;
  using Winner = TrianglePair;

  BodyQuestion(const Body& mover, const DistanceOptions& options, const Limits& limits)
      : mover_(mover),
        box_(detail::moved_bounds(mover.pose, mover.shape.bounds())),
        options_(options),
        limits_(limits) {}

  [[nodiscard]] static const Bracket& measure(const Distance& answer) { return answer.distance; }

  [[nodiscard]] double key(const Box& box) const { return detail::distance_at_least(box_, box); }

  [[nodiscard]] double limit() const { return options_.at_most; }

  [[nodiscard]] bool late() const { return limits_.late(); }

  [[nodiscard]] Distance ask(const Body& body, const OpenTile& /*tile*/, double limit) const {
    Distance answer = soms::distance(mover_, body, {limit}, limits_);
    if (answer.coverage == Coverage::cut && answer.triangles) {
      // What was proved of the tile is not what is measured.
      answer.distance = pair_of(body, *answer.triangles).distance();
    }
    return answer;
  }

  [[nodiscard]] static std::optional<TrianglePair> winner(const Distance& answer,
                                                          const OpenTile& tile) {
    return answer.triangles
               ? std::optional(TrianglePair{answer.triangles->a, tile.number(answer.triangles->b)})
               : std::nullopt;
  }

  [[nodiscard]] std::strong_ordering compare(const Body& body, const TrianglePair& pair,
                                             const Body& other, const TrianglePair& others) const {
    detail::PairDistance here = pair_of(body, pair);
    detail::PairDistance there = pair_of(other, others);
    return here.compare(there);
  }

 private:
  [[nodiscard]] detail::PairDistance pair_of(const Body& body, const TrianglePair& pair) const {
    return {detail::moved_triangle(mover_, pair.a), detail::moved_triangle(body, pair.b)};
  }

  const Body& mover_;
  Box box_;
  const DistanceOptions& options_;
  const Limits& limits_;
};

Distance distance_of(const Body& mover, const detail::TileBoxes& tiles,
                     const DistanceOptions& options, const Limits& limits) {
  if (mover.shape.bounds().empty() || tiles.body().tiles.triangles() == 0) {
    return {.distance = {kInfinity, kInfinity}};
  }
  const BodyQuestion question(mover, options, limits);
  detail::NearestTile nearest(question);
  std::vector<detail::KeyedBounds> memory;
  nearest.run(tiles, memory);
  Distance answer;
  if (nearest.found()) {
    answer = nearest.found()->answer;
    answer.triangles = nearest.found()->winner;
  } else {
    answer.farther = !nearest.cut();
    answer.distance = {answer.farther ? options.at_most : kInfinity, kInfinity};
  }
  answer.coverage = Coverage::complete;
  if (nearest.cut()) {
    answer.coverage = Coverage::cut;
    answer.distance.lower = std::min(answer.distance.lower, nearest.at_least());
  }
  answer.cost = nearest.cost();
  return answer;
}

Within within_of(const Body& mover, const detail::TileBoxes& tiles, double clearance,
                 const Limits& limits) {
  if (mover.shape.bounds().empty() || tiles.body().tiles.triangles() == 0) {
    return {.at_least = kInfinity};
  }
  const Box box = detail::moved_bounds(mover.pose, mover.shape.bounds());
  const auto key = [&](const Box& other) { return detail::distance_at_least(box, other); };
  Within answer{.at_least = clearance};
  Cost cost;
  std::vector<detail::KeyedBounds> memory;
  cost.node_tests +=
      tiles.boxes().search(key, clearance, memory, [&](std::uint32_t number, double nearest) {
        if (limits.late()) {
          answer = {.at_least = nearest, .coverage = Coverage::cut};
          return -kInfinity;
        }
        const auto tile = tiles.open(number);
        const Within here =
            soms::within(mover, Body(tile->shape, tiles.body().pose), clearance, limits);
        cost += here.cost;
        if (!here.within && here.coverage == Coverage::complete) {
          return clearance;
        }
        answer = here;
        if (here.within) {
          answer.triangles->b = tile->number(here.triangles->b);
        } else {
          // Tiles that were not met may be as near as the key of this one.
          answer.at_least = std::min(answer.at_least, nearest);
        }
        return -kInfinity;  // decided, or out of time
      });
  answer.cost = cost;
  return answer;
}

/// The box of a mover at a pose tells where its row begins.
template <class Ask>
void for_each_pose(const Shape& mover, std::span<const Pose> poses, const detail::TileBoxes& tiles,
                   const Limits& limits, const Ask& ask) {
  const Limits alone = limits.alone();
  const bool single = poses.size() == 1;
  detail::for_each_row(
      tiles.body().tiles, poses.size(), limits,
      [&](std::size_t row) {
        const Box box = detail::moved_bounds(poses[row], mover.bounds());
        return detail::first_tile(
            tiles, [&](const Box& other) { return detail::distance_at_least(box, other); });
      },
      [&](std::size_t row) { ask(row, Body(mover, poses[row]), single ? limits : alone); });
}

}  // namespace

DistanceBatch distance(const Shape& mover, std::span<const Pose> poses, const TiledBody& fixed,
                       const DistanceOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  detail::check_options(options);
  detail::check_poses(poses, mover);
  const detail::TileBoxes tiles(fixed);
  check_stop(limits);
  // The columns of a shape without triangles are of the right size.
  DistanceBatch batch = distance(mover, poses, Body(), options);
  for_each_pose(mover, poses, tiles, limits,
                [&](std::size_t row, const Body& body, const Limits& threads) {
                  put_columns(distance_of(body, tiles, options, threads), row, batch);
                });
  sum_costs<Distance>(batch);
  return batch;
}

WithinBatch within(const Shape& mover, std::span<const Pose> poses, const TiledBody& fixed,
                   double clearance, const Limits& limits) {
  const PlainArithmetic plain;
  detail::check_poses(poses, mover);
  const detail::TileBoxes tiles(fixed);
  check_stop(limits);
  WithinBatch batch = within(mover, poses, Body(), clearance);  // checks the clearance
  for_each_pose(mover, poses, tiles, limits,
                [&](std::size_t row, const Body& body, const Limits& threads) {
                  put_columns(within_of(body, tiles, clearance, threads), row, batch);
                });
  sum_costs<Within>(batch);
  return batch;
}

}  // namespace soms
