/// \file
/// The rows of a clash list: sorted, filtered, and compared with an older list.
#pragma once

#include "soms/clash/clash.h"

#include "apps/soms/clash/clash_models.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

inline constexpr std::size_t kClashKinds = 6;

/// How many clashes there are of each kind.
using ClashCounts = std::array<std::uint64_t, kClashKinds>;

/// What an older list says of a clash.
enum class ClashStatus : unsigned char {
  unknown,  ///< there is no older list
  fresh,    ///< the older list does not have it
  active,   ///< it has
};

struct ClashRow {
  Clash clash;
  std::uint64_t key = 0;
  std::string group = {};
  ClashStatus status = ClashStatus::unknown;
};

/// A list as it is written.
struct ClashReport {
  const ClashModels& models;
  std::vector<ClashRow> rows = {};  ///< by kind, then by the names of the parts
  std::vector<Json> resolved = {};  ///< rows of the older list that this one has not
  ClashCounts by_kind = {};
  std::vector<std::pair<std::string, std::uint64_t>> removed = {};  ///< by which option, how many
  std::uint64_t compared = 0;  ///< pairs of parts that were decided
  std::uint64_t left = 0;      ///< pairs of parts that were not, as time ended or Ctrl-C came
  bool has_baseline = false;
  bool interrupted = false;
  bool timed_out = false;
  Cost cost = {};
  std::uint64_t resumed = 0;        ///< pairs of parts that a journal had
  std::uint64_t unknown_depth = 0;  ///< rows that a tolerance could not judge
  bool removed_by_tolerance = false;
  bool grouped = false;

  [[nodiscard]] bool complete() const { return left == 0; }
};

/// Pairs of parts that somebody does not want to see.
class IgnoredPairs {
 public:
  /// None.
  IgnoredPairs() = default;

  /// Lines "PATTERN,PATTERN", in quotes where a name has a comma; empty ones and those that begin
  /// with # are passed over. Patterns are those of shells: * ? [a-z].
  /// \errors ErrorKind::cannot_open; bad_file, with the line.
  explicit IgnoredPairs(const std::string& file);

  /// True if a line has a pattern for each of the two, in either order: for the path of its names,
  /// its last name, or its id. Of an open group, for each of its parts.
  [[nodiscard]] bool match(const ClashModels& models, const Clash& clash) const;

 private:
  std::vector<std::pair<std::string, std::string>> pairs_;
};

/// "new" or "active"; empty where there is no older list.
[[nodiscard]] std::string_view status_name(ClashStatus status);

/// The status of a row of the older list that is gone.
inline constexpr std::string_view kResolved = "resolved";

/// A key as text: 16 hexadecimal digits.
[[nodiscard]] std::string key_text(std::uint64_t key);

/// Counts of each pair of sets that has clashes, by their names. Of one set compared with itself
/// the lesser name is first.
[[nodiscard]] std::vector<std::pair<std::pair<std::string, std::string>, ClashCounts>>
counts_by_sets(const ClashReport& report);

/// Counts of each group, the largest first, then by name.
[[nodiscard]] std::vector<std::pair<std::string, ClashCounts>> counts_by_group(
    const ClashReport& report);

/// Sorts rows by kind, then by the paths of names, files and numbers of the parts.
void sort_rows(const ClashModels& models, std::vector<ClashRow>& rows);

/// The same rows with the worst of each kind first: the deepest, where a depth is known, then those
/// of most pairs of triangles; of parts that are near, the nearest.
[[nodiscard]] std::vector<const ClashRow*> worst_first(const std::vector<ClashRow>& rows);

}  // namespace soms::command
