/// \file
/// The files of --shard: answers of a share of the rows, and the receipt that makes them valid.
#pragma once

#include "apps/output/json.h"
#include "apps/rows/answer_outputs.h"
#include "apps/rows/pose_source.h"
#include "apps/rows/shard.h"
#include "apps/shards/posed_models.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace soms::command {

class Console;
class Parser;

/// A share of the rows on its way into files whose names end with its number: DIR/shard-K.npz and
/// DIR/shard-K.csv of -o DIR/shard.npz and -o DIR/shard.csv. DIR/shard-K.json is the receipt, which
/// appears last.
class ShardFiles {
 public:
  /// Finds out which rows they are, makes the folder, and changes `outputs` to the files of the
  /// share. `question` is what the verb asks, as far as its options say.
  /// \errors ErrorKind::usage for options that do not go with --shard; those of poses.
  ShardFiles(const PosedModels& options, Json question, AnswerOutputs& outputs,
             const Console& console);

  /// Whether the answers are there and whole. Reads the models if there is a receipt.
  /// \errors ErrorKind::bad_file for a receipt of another question; those of models.
  [[nodiscard]] bool are_there(const PosedModels& options, const Console& console) const;

  [[nodiscard]] const RowRange& rows() const { return rows_; }

  /// The poses of these rows.
  [[nodiscard]] PosePairs poses(const PosedModels& options, const Console& console) const;

  /// Writes the receipt, once the answers about the models of these entries are written.
  /// \errors ErrorKind::cannot_write.
  void finish(const Json& a, const Json& b, const Console& console) const;

 private:
  [[nodiscard]] Json receipt(const Json& a, const Json& b) const;

  Shard shard_;
  std::filesystem::path stem_;  ///< DIR/shard-K
  std::optional<std::uint64_t> rows_a_;
  std::optional<std::uint64_t> rows_b_;
  std::uint64_t of_ = 1;
  RowRange rows_;
  Json question_;
  Json poses_;
  bool csv_ = false;
  bool npz_ = false;
};

/// Adds --shard, under a heading.
void add_shard(Parser& parser, PosedModels& options, const char* heading);

/// Sets `files` of the options if they have --shard; `question` is what the verb asks, and
/// `has_condition` is true of --fail-if. False if the answers are there already.
/// \errors As `ShardFiles`.
[[nodiscard]] bool begin_shard(PosedModels& options, Json question, bool has_condition,
                               const Console& console);

}  // namespace soms::command
