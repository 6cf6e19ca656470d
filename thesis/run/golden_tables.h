/// \file
/// The golden tables of the thesis' experiments: counts that an independent program wrote.
#pragma once

#include "thesis/trips/contenders.h"
#include "thesis/trips/frames.h"
#include "thesis/trips/models.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::reproduce {

/// A golden table: its file, the names of its columns, and how many of them, the first ones, say
/// what was counted. The others are counts, and so is `triangles`.
struct GoldenLayout {
  std::string_view file;
  std::vector<std::string_view> columns;
  std::size_t keys = 0;
};

/// thesis_counts.csv: a row for each tree.
[[nodiscard]] const GoldenLayout& golden_trees();

/// thesis_traversal.csv: a row for each traversal of each trip.
[[nodiscard]] const GoldenLayout& golden_traversals();

/// A row as it was read.
struct GoldenRow {
  std::size_t line = 0;                 ///< of the file; the first has the names of the columns
  std::vector<std::string> cells = {};  ///< \shape as many as the table has columns
};

/// A row of thesis_counts.csv.
struct GoldenTree {
  GoldenRow row = {};
  std::string model = {};
  Contender build = {};
};

/// What the rows of one trip share.
struct GoldenTrip {
  std::string still;   ///< name of the model that stands still
  std::string moving;  ///< name of the model that moves, enlarged if it drives
  std::string rule;    ///< of both trees
  std::string test;    ///< an approach, or "drive"

  [[nodiscard]] auto operator<=>(const GoldenTrip&) const = default;
};

/// A row of thesis_traversal.csv.
struct GoldenTraversal {
  GoldenRow row = {};
  GoldenTrip trip = {};
  NamedTraversal traversal = {};
};

/// Both tables.
struct GoldenTables {
  std::vector<GoldenTree> trees = {};
  std::vector<GoldenTraversal> traversals = {};
};

/// The models that were counted, by the FNV-1a 64 of their coordinates, triangle by triangle.
inline constexpr std::array<std::pair<std::string_view, std::uint64_t>, 7> kGoldenHashes{
    {{"bunny", 0x23e1390559ce62edULL},
     {"u_boxes", 0x57cb92e64471a071ULL},
     {"u_mixed", 0x5e44b5637f4cb56cULL},
     {"u_plain", 0xb2dc50f5a09a47cdULL},
     {"venus", 0xb4c5b8d4374d26cdULL},
     {"teapot_1177", 0x443d997a2f94d83aULL},
     {"teapot", 0x3d13e5f55250fafcULL}}};

/// Reads both tables from a folder.
/// \errors ErrorKind::cannot_open without a file; bad_file for other columns, a row that is too
/// short or too long, or one that names a model, rule, option, test or traversal that is not known.
[[nodiscard]] GoldenTables read_golden(const std::filesystem::path& folder);

/// The trip of these models with the trees of the golden table.
[[nodiscard]] Trip made(const GoldenTrip& trip, const Model& still, const Model& moving);

}  // namespace soms::reproduce
