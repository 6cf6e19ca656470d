// The point of tiles that is nearest to another one, and what rays hit first.
#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/describe/columns.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/scene/detail/search/measures.h"
#include "soms/tiles/detail/nearest_tile.h"
#include "soms/tiles/tiled_queries.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <string>

namespace soms {

namespace {

constexpr double kBeyondAll = std::numeric_limits<double>::infinity();

std::optional<TriangleId> number_in_all(const std::optional<TriangleId>& triangle,
                                        const OpenTile& tile) {
  return triangle ? std::optional(tile.number(*triangle)) : std::nullopt;
}

/// How far are the surfaces from a point?
class PointQuestion : public detail::PointMeasure {
 public:
  using Answer = Closest;
  using Winner = TriangleId;

  PointQuestion(const Vec3& point, const ClosestOptions& options, const Limits& limits)
      : PointMeasure(point, options, limits), limits_(limits) {}

  [[nodiscard]] bool late() const { return limits_.late(); }

  [[nodiscard]] Closest ask(const Body& body, const OpenTile& /*tile*/, double limit) const {
    return nearest(body, limit);
  }

  [[nodiscard]] static std::optional<TriangleId> winner(const Closest& answer,
                                                        const OpenTile& tile) {
    return number_in_all(answer.triangle, tile);
  }

 private:
  const Limits& limits_;
};

/// Where does a ray meet the surfaces first, if at all?
class LineQuestion : public detail::LineMeasure {
 public:
  using Answer = ClosestHit;
  using Winner = TriangleId;

  LineQuestion(const Ray& given, const RayOptions& options, const Limits& limits)
      : detail::LineMeasure(given), options_(options), limits_(limits) {}

  [[nodiscard]] bool late() const { return limits_.late(); }

  [[nodiscard]] ClosestHit ask(const Body& body, const OpenTile& tile, double limit) const {
    return soms::closest_hit(body, detail::shortened(line(), limit), options_for(tile), limits_);
  }

  [[nodiscard]] AnyHit ask_any(const Body& body, const OpenTile& tile) const {
    return soms::any_hit(body, line(), options_for(tile), limits_);
  }

  [[nodiscard]] static std::optional<TriangleId> winner(const ClosestHit& answer,
                                                        const OpenTile& tile) {
    return number_in_all(answer.triangle, tile);
  }

 private:
  /// The triangle to skip is in one tile.
  [[nodiscard]] RayOptions options_for(const OpenTile& tile) const {
    RayOptions options;
    if (options_.skip) {
      const auto at = std::lower_bound(tile.ids.begin(), tile.ids.end(), *options_.skip);
      if (at != tile.ids.end() && *at == *options_.skip) {
        options.skip = static_cast<TriangleId>(at - tile.ids.begin());
      }
    }
    return options;
  }

  const RayOptions& options_;
  const Limits& limits_;
};

void check_skip(const TileSet& tiles, const RayOptions& options) {
  if (options.skip && *options.skip >= tiles.triangles()) {
    throw Error(ErrorKind::usage,
                "ray options: there is no triangle " + std::to_string(*options.skip) + " to skip",
                "triangles are numbered from 0, through all tiles");
  }
}

ClosestHit first_hit(const Ray& line, const detail::TileBoxes& tiles, const RayOptions& options,
                     const Limits& limits) {
  const LineQuestion question(line, options, limits);
  detail::NearestTile nearest(question);
  std::vector<detail::KeyedBounds> memory;
  nearest.run(tiles, memory);
  ClosestHit answer;
  if (nearest.found()) {
    answer = nearest.found()->answer;
    answer.triangle = nearest.found()->winner;
  }
  answer.coverage = Coverage::complete;
  if (nearest.cut()) {
    answer.coverage = Coverage::cut;
    answer.t.lower = std::min(answer.t.lower, nearest.at_least());
  }
  answer.cost = nearest.cost();
  return answer;
}

AnyHit some_hit(const Ray& line, const detail::TileBoxes& tiles, const RayOptions& options,
                const Limits& limits) {
  const LineQuestion question(line, options, limits);
  AnyHit answer;
  std::vector<detail::KeyedBounds> memory;
  const auto key = [&](const Box& box) { return question.key(box); };
  answer.cost.node_tests += tiles.boxes().search(
      key, question.limit(), memory, [&](std::uint32_t number, double /*key*/) {
        if (question.late()) {
          answer.coverage = Coverage::cut;
          return -kBeyondAll;
        }
        const auto tile = tiles.open(number);
        const AnyHit here = question.ask_any(Body(tile->shape, tiles.body().pose), *tile);
        answer.hit = here.hit;
        answer.coverage = here.coverage;
        answer.cost += here.cost;
        return here.hit || here.coverage == Coverage::cut ? -kBeyondAll : question.limit();
      });
  return answer;
}

/// `ask(row)` for each line.
template <class Ask>
void for_each_line(std::span<const Ray> lines, const detail::TileBoxes& tiles, const Limits& limits,
                   const Ask& ask) {
  detail::for_each_row(
      tiles.body().tiles, lines.size(), limits,
      [&](std::size_t row) {
        const LineQuestion question(lines[row], {}, limits);
        return detail::first_tile(tiles, [&](const Box& box) { return question.key(box); });
      },
      ask);
}

// What a body without triangles answers is checked, and its columns are of the right size.

ClosestHitBatch first_hits(const TiledBody& body, std::span<const Ray> lines,
                           const RayOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  check_skip(body.tiles, options);
  const detail::TileBoxes tiles(body);
  ClosestHitBatch batch = closest_hit(Body(), lines);
  const Limits alone = limits.alone();
  for_each_line(lines, tiles, limits, [&](std::size_t row) {
    put_columns(first_hit(lines[row], tiles, options, alone), row, batch);
  });
  sum_costs<ClosestHit>(batch);
  return batch;
}

AnyHitBatch some_hits(const TiledBody& body, std::span<const Ray> lines, const RayOptions& options,
                      const Limits& limits) {
  const PlainArithmetic plain;
  check_skip(body.tiles, options);
  const detail::TileBoxes tiles(body);
  AnyHitBatch batch = any_hit(Body(), lines);
  const Limits alone = limits.alone();
  for_each_line(lines, tiles, limits, [&](std::size_t row) {
    put_columns(some_hit(lines[row], tiles, options, alone), row, batch);
  });
  sum_costs<AnyHit>(batch);
  return batch;
}

Closest closest_of(const Vec3& point, const detail::TileBoxes& tiles, const ClosestOptions& options,
                   const Limits& limits) {
  const PointQuestion question(point, options, limits);
  detail::NearestTile nearest(question);
  std::vector<detail::KeyedBounds> memory;
  nearest.run(tiles, memory);
  Closest answer;
  if (nearest.found()) {
    answer = nearest.found()->answer;
    answer.triangle = nearest.found()->winner;
  } else {
    answer.farther = !nearest.cut() && tiles.body().tiles.triangles() > 0;
    answer.distance = {answer.farther ? options.at_most : kBeyondAll, kBeyondAll};
  }
  answer.coverage = Coverage::complete;
  if (nearest.cut()) {
    answer.coverage = Coverage::cut;
    answer.distance.lower = std::min(answer.distance.lower, nearest.at_least());
  }
  answer.cost = nearest.cost();
  return answer;
}

}  // namespace

ClosestBatch closest(const TiledBody& body, std::span<const Vec3> points,
                     const ClosestOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  const detail::TileBoxes tiles(body);
  ClosestBatch batch = closest(Body(), points, options);
  const Limits alone = limits.alone();
  detail::for_each_row(
      body.tiles, points.size(), limits,
      [&](std::size_t row) {
        return detail::first_tile(
            tiles, [&](const Box& box) { return detail::distance_at_least(points[row], box); });
      },
      [&](std::size_t row) {
        put_columns(closest_of(points[row], tiles, options, points.size() == 1 ? limits : alone),
                    row, batch);
      });
  sum_costs<Closest>(batch);
  return batch;
}

ClosestHitBatch closest_hit(const TiledBody& body, std::span<const Ray> rays,
                            const RayOptions& options, const Limits& limits) {
  return first_hits(body, rays, options, limits);
}

AnyHitBatch any_hit(const TiledBody& body, std::span<const Ray> rays, const RayOptions& options,
                    const Limits& limits) {
  return some_hits(body, rays, options, limits);
}

}  // namespace soms
