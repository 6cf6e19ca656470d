/// \file
/// What lies beside the answers of a share of the rows: the question, what identifies models and
/// poses, and which bytes the answers are.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/tiles/tile_set.h"

#include "apps/output/json.h"
#include "apps/rows/shard.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace soms::command {

inline constexpr const char* kShardSchema = "soms.shard/1";

/// Receipts have four levels.
inline constexpr int kDeepestReceipt = 8;

/// A receipt that was read, and where.
struct Receipt {
  std::filesystem::path path;
  Json value;

  /// The rows that it is of.
  [[nodiscard]] RowRange rows() const;

  /// How many rows the input has.
  [[nodiscard]] std::uint64_t of() const;

  /// "npz" and "csv", those that there are.
  [[nodiscard]] std::vector<std::string> kinds() const;

  /// The file of answers of a kind.
  [[nodiscard]] std::filesystem::path file(const std::string& kind) const;

  /// Whether that file has the bytes that the receipt states.
  [[nodiscard]] bool is_whole(const std::string& kind) const;
};

/// Reads a receipt. \errors ErrorKind::cannot_open; bad_file for what is none.
[[nodiscard]] Receipt read_receipt(const std::filesystem::path& path);

/// What a receipt says of a file of answers.
[[nodiscard]] Json file_entry(const std::filesystem::path& path);

/// What identifies a model: its triangles, as they were read, scaled and turned.
[[nodiscard]] Json model_entry(const MeshView& mesh);
[[nodiscard]] Json model_entry(const TileSet& tiles);

/// What identifies the poses of an option: a pose as it is stated, or the size of a file, the
/// number of its rows and its first and last bytes, so that files of many gigabytes need not be
/// read.
[[nodiscard]] Json poses_entry(const std::optional<std::string>& text,
                               const std::optional<std::uint64_t>& rows);

/// The first thing that two receipts say otherwise of what all shards of an answer have in common,
/// such as "question.mode"; nothing if they agree.
[[nodiscard]] std::optional<std::string> difference(const Json& a, const Json& b);

}  // namespace soms::command
