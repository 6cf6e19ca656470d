/// \file
/// Rows of poses of two models, which are read first.
#pragma once

#include "soms/query/body.h"
#include "soms/tiles/tile_set.h"

#include "apps/model/file_numbers.h"
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
#include <variant>
#include <vector>

namespace soms::command {

/// What a verb says of its question.
struct PoseTerms {
  std::string verb;            ///< as messages name it
  Json terms = {};             ///< the options of the question, for receipts of shards
  bool fail_if_found = false;  ///< --fail-if is given
  bool keep_trees = false;     ///< a named traversal needs the canonical trees
  bool doubts_gaps = true;     ///< boxes that are far apart make the answer doubtful
  double expected_gap = 0;     ///< up to here they do not
  bool is_free = false;        ///< several answers would be right
  /// Where B may be a folder of tiles: what has no meaning then.
  std::optional<std::vector<RefusedOfTiles>> refused_of_tiles = std::nullopt;
};

/// A page, for `refused_of_tiles`.
[[nodiscard]] RefusedOfTiles refused_page(const AnswerOutputs& outputs);

/// B, where it stands still: a body, or a folder of tiles.
using StillBody = std::variant<Body, TiledBody>;

/// Answers rows of the block.
class PoseAnswers {
 public:
  PoseAnswers() = default;
  PoseAnswers(const PoseAnswers&) = delete;
  PoseAnswers& operator=(const PoseAnswers&) = delete;

  /// Row `k`.
  virtual void answer_one(std::size_t k, const Body& a, const Body& b, const Limits& limits) = 0;
  /// The rows from `begin` on, in which B stands still.
  virtual void answer_some(std::size_t begin, const Shape& a, std::span<const Pose> poses,
                           const StillBody& b, const Limits& limits) = 0;

 protected:
  ~PoseAnswers() = default;
};

class PoseRows : public Rows {
 public:
  /// Opens the poses and reads the models.
  PoseRows(const PairOptions& options, PoseTerms terms, Console& console);

  [[nodiscard]] RowRunOptions run_options() const;

  [[nodiscard]] const PairOptions& options() const { return options_; }

  [[nodiscard]] const PairReport& pair() const { return report_; }

  /// The models.
  [[nodiscard]] const Shape& shape_a() const { return a_.shape; }

  /// Empty where B is a folder of tiles.
  [[nodiscard]] const Shape& shape_b() const { return b_.shape; }

  /// Rows of the block.
  [[nodiscard]] std::size_t size() const { return block_.size(); }

  /// The bodies of row `k` of the block.
  [[nodiscard]] const Pose& pose_a(std::size_t k) const { return block_[k].first; }

  [[nodiscard]] const Pose& pose_b(std::size_t k) const { return block_[k].second; }

  [[nodiscard]] Body body_a(std::size_t k) const { return Body(a_.shape, pose_a(k)); }

  [[nodiscard]] Body body_b(std::size_t k) const { return Body(b_.shape, pose_b(k)); }

  /// Has the rows of the block answered.
  void answer(PoseAnswers& answers, const ShowProgress& show) const;

  void begin() override;

  [[nodiscard]] bool is_single() const override { return report_.single; }

  [[nodiscard]] bool are_listed() const override { return report_.lists_rows; }

  void clear() override;

  bool ready() override { return poses_.ready(); }

  bool read() override;
  void report(const AnsweredRow& row) override;
  void doubt() override;
  bool end(RunEnd end) override;
  void finish() override;

 private:
  static PosePairs poses_of(const PairOptions& options, const Console& console);
  static PoseSource source(const std::string& option, const std::optional<std::string>& text,
                           const Console& console);
  ModelShape load(const std::string& path, const ModelOptions& model) const;
  std::optional<TileSet> load_tiles() const;
  [[nodiscard]] const Box& bounds_b() const;
  void doubt_all_boxes();
  void check_row(const std::pair<Pose, Pose>& row) const;
  void check_pose(const Pose& pose, const Box& bounds, const std::string& file) const;
  [[nodiscard]] std::string place_of(std::size_t k, const std::string& file,
                                     const Error& error) const;
  void answer_row(PoseAnswers& answers, Body& a, Body& b, std::size_t k,
                  const Limits& limits) const;
  void answer_rows(PoseAnswers& answers, std::size_t begin, std::size_t end,
                   const Limits& limits) const;
  [[nodiscard]] std::vector<Pose> poses_a(std::size_t begin, std::size_t end) const;
  [[nodiscard]] std::size_t end_of_run(std::size_t begin, std::size_t end) const;

  PairOptions options_;
  PoseTerms terms_;
  Console& console_;
  PosePairs poses_;
  ModelShape a_;
  std::optional<TileSet> tiles_;  ///< in place of `b_`
  ModelShape b_;
  PairReport report_;
  std::vector<std::pair<Pose, Pose>> block_;
  std::uint64_t before_;  ///< rows of the input before the block
  BoxWatch boxes_;
};

}  // namespace soms::command
