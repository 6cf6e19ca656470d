/// \file
/// Two models at rows of poses: read, and queried pose by pose.
#pragma once

#include "soms/query/body.h"
#include "soms/tiles/tile_set.h"

#include "apps/output/json.h"
#include "apps/rows/pose_source.h"
#include "apps/rows/row_run.h"
#include "apps/soms/pairs/pair_options.h"
#include "apps/soms/pairs/pair_report.h"
#include "apps/store/tiles.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

/// What a verb says of its question.
struct PoseQuestion {
  std::string verb;            ///< as messages name it
  Json terms = {};             ///< the options of the question, for receipts of shards
  bool fail_if_found = false;  ///< --fail-if is given
  bool has_files = false;      ///< answers go to files, too
  bool keep_trees = false;     ///< a named traversal needs the canonical trees
  bool doubts_gaps = true;     ///< boxes that are far apart make the answer doubtful
  double expected_gap = 0;     ///< up to here they do not
  bool is_free = false;        ///< several answers would be right
  /// Where B may be a folder of tiles: what has no meaning then.
  std::optional<std::vector<RefusedOfTiles>> refused_of_tiles = std::nullopt;
};

/// A run whose rows are poses of two models. A verb adds its question and its output.
class PoseRun : public RowRun {
 protected:
  /// Opens the poses and reads the models.
  PoseRun(const PairOptions& options, PoseQuestion question, Console& console);

  [[nodiscard]] const PairReport& report() const { return report_; }

  /// The models.
  [[nodiscard]] const Shape& shape_a() const { return a_; }

  /// Empty where B is a folder of tiles.
  [[nodiscard]] const Shape& shape_b() const { return b_; }

  /// The bodies of row `k` of the block.
  [[nodiscard]] const Pose& pose_a(std::size_t k) const { return block_[k].first; }

  [[nodiscard]] const Pose& pose_b(std::size_t k) const { return block_[k].second; }

  [[nodiscard]] Body body_a(std::size_t k) const { return Body(a_, pose_a(k)); }

  [[nodiscard]] Body body_b(std::size_t k) const { return Body(b_, pose_b(k)); }

 private:
  /// Makes room for the answers of a block.
  virtual void reserve(std::size_t rows) = 0;
  /// Answers row `k`, whose bodies are given.
  virtual void ask(std::size_t k, const Body& a, const Body& b, const Parallel& parallel) = 0;
  /// Answers the rows from `begin` on, in which B stands still.
  virtual void ask(std::size_t begin, const Shape& a, std::span<const Pose> poses, const Body& b,
                   const Parallel& parallel) = 0;

  /// The same where B is a folder of tiles, for a question that has an answer there.
  virtual void ask_tiles(std::size_t /*begin*/, const Shape& /*a*/, std::span<const Pose> /*poses*/,
                         const TiledBody& /*b*/, const Parallel& /*parallel*/) {}

  /// How many things the answers of the block hold.
  [[nodiscard]] virtual std::uint64_t held() const { return 0; }

  /// Prints the answer of row `k`, of pose `number()`, by `report()`.
  virtual void print_answer(std::size_t k, bool right) = 0;
  /// Finishes the files of answers, by `report()`.
  virtual void finish_outputs() = 0;

  void begin() final;

  [[nodiscard]] bool is_single() const final { return report_.single; }

  void clear_block() final { block_.clear(); }

  bool ready() final { return poses_.ready(); }

  bool read_row() final;
  std::uint64_t answer_block() final;
  void print_row(std::size_t k, bool right, bool last) final;
  void doubt() final;
  void finish(End end) final;

  static PosePairs poses_of(const PairOptions& options, const Console& console);
  static PoseSource source(const std::string& option, const std::optional<std::string>& text,
                           const Console& console);
  Shape load(const std::string& path, const ModelOptions& model) const;
  std::optional<TileSet> load_tiles() const;
  [[nodiscard]] const Box& bounds_b() const;
  void look_at_boxes(std::size_t k);
  void doubt_all_boxes();
  void check_row(const std::pair<Pose, Pose>& row) const;
  void check_pose(const Pose& pose, const Box& bounds, const std::string& file) const;
  [[nodiscard]] std::string place_of(std::size_t k, const std::string& file,
                                     const Error& error) const;
  void answer_row(Body& a, Body& b, std::size_t k, const Parallel& parallel);
  void answer_rows(std::size_t begin, std::size_t end, const Parallel& parallel);
  void answer_of_tiles(const Parallel& parallel);
  [[nodiscard]] std::size_t end_of_run(std::size_t begin, std::size_t end) const;

  PairOptions options_;
  PoseQuestion question_;
  PosePairs poses_;
  Shape a_;
  std::optional<TileSet> tiles_;  ///< in place of `b_`
  Shape b_;
  PairReport report_;
  std::vector<std::pair<Pose, Pose>> block_;
  BoxWatch boxes_;
};

}  // namespace soms::command
