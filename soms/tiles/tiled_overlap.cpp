// Which triangles of a mover touch those of tiles: the pairs of each tile, put together.
#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/motion/detail/moved_bounds.h"
#include "soms/query/detail/check_options.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/tiles/detail/tile_boxes.h"
#include "soms/tiles/tiled_queries.h"

#include <algorithm>
#include <utility>

namespace soms {

namespace {

/// Pairs of all tiles, and what is known of each row.
class TiledPairs {
 public:
  TiledPairs(std::size_t rows, OverlapMode mode)
      : mode_(mode), pairs_(rows), coverage_(rows, Coverage::complete), costs_(rows) {}

  /// A tile has nothing more to add to this row.
  [[nodiscard]] bool is_decided(std::size_t row) const {
    return mode_ == OverlapMode::any && !pairs_[row].empty();
  }

  /// Adds the answer of a tile for some rows.
  void add(std::span<const std::size_t> rows, const OverlapBatch& answer, const OpenTile& tile) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const std::size_t row = rows[k];
      costs_[row] += answer.costs[k];
      // What is cut elsewhere is found here all the same.
      coverage_[row] = mode_ == OverlapMode::any && answer.any[k] != 0
                           ? answer.coverage[k]
                           : std::max(coverage_[row], answer.coverage[k]);
      for (const TrianglePair& pair : answer.pairs_of(k)) {
        pairs_[row].push_back({pair.a, tile.number(pair.b)});
      }
    }
  }

  /// Time is up for these rows.
  void cut(std::span<const std::size_t> rows) {
    for (const std::size_t row : rows) {
      coverage_[row] = Coverage::cut;
    }
  }

  [[nodiscard]] OverlapBatch batch() {
    OverlapBatch batch;
    batch.offsets.push_back(0);
    for (std::vector<TrianglePair>& pairs : pairs_) {
      std::sort(pairs.begin(), pairs.end());
      if (mode_ != OverlapMode::all && pairs.size() > 1) {
        pairs.resize(1);
      }
      batch.any.push_back(pairs.empty() ? 0 : 1);
      detail::append(batch.pairs, pairs);
      batch.offsets.push_back(batch.pairs.size());
      pairs = {};
    }
    batch.coverage = std::move(coverage_);
    batch.costs = std::move(costs_);
    batch.cost = detail::sum_of(batch.costs);
    return batch;
  }

 private:
  OverlapMode mode_;
  std::vector<std::vector<TrianglePair>> pairs_;
  std::vector<Coverage> coverage_;
  std::vector<Cost> costs_;
};

/// The rows that meet each tile.
std::vector<std::vector<std::size_t>> rows_of_tiles(const Shape& mover, std::span<const Pose> poses,
                                                    const detail::TileBoxes& tiles) {
  std::vector<std::vector<std::size_t>> rows(tiles.body().tiles.tiles().size());
  if (!mover.bounds().empty()) {
    for (std::size_t row = 0; row < poses.size(); ++row) {
      tiles.boxes().query(detail::moved_bounds(poses[row], mover.bounds()),
                          [&](std::uint32_t tile) { rows[tile].push_back(row); });
    }
  }
  return rows;
}

void check_limit(const OverlapOptions& options) {
  if (options.limit != OverlapOptions().limit) {
    throw Error(ErrorKind::usage, "overlap options: a limit of pairs of tiles",
                "leave it out: the first pairs of all tiles are not known before all are found");
  }
}

}  // namespace

OverlapBatch overlap(const Shape& mover, std::span<const Pose> poses, const TiledBody& fixed,
                     const OverlapOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  detail::check_options(options);
  check_limit(options);
  detail::check_poses(poses, mover);
  const detail::TileBoxes tiles(fixed);
  check_stop(limits);
  const Limits silent = limits.silent();
  const auto rows_of = rows_of_tiles(mover, poses, tiles);
  TiledPairs found(poses.size(), options.mode);
  std::vector<std::size_t> rows;
  std::vector<Pose> here;
  for (std::size_t number = 0; number < rows_of.size(); ++number) {
    rows.clear();
    here.clear();
    for (const std::size_t row : rows_of[number]) {
      if (!found.is_decided(row)) {
        rows.push_back(row);
        here.push_back(poses[row]);
      }
    }
    if (!rows.empty() && limits.late()) {
      found.cut(rows);
    } else if (!rows.empty()) {
      const auto tile = tiles.open(number);
      found.add(rows, overlap(mover, here, Body(tile->shape, fixed.pose), options, silent), *tile);
    }
    if (limits.progress) {
      limits.progress(static_cast<double>(number + 1) / static_cast<double>(rows_of.size()));
    }
  }
  return found.batch();
}

}  // namespace soms
