/// \file
/// Rows of a clash list with the parts and places that pictures of them need, those that are
/// resolved, too.
#pragma once

#include "soms/base/box.h"

#include "apps/soms/clash/clash_rows.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace soms::command {

/// By which a part is found again: "i" and its id, or "p" and its path.
[[nodiscard]] std::string side_mark(const Json& side);

/// Numbers of the parts of a set, by their marks.
using MarkedParts = std::unordered_map<std::string, std::vector<std::uint32_t>>;
[[nodiscard]] MarkedParts marked_parts(const ClashSet& set);

/// A row of the list.
struct ListedClash {
  Json row = {};  ///< as JSON has it, with its status
  /// Number of the part in the first set, and in the second. Nothing where the models do not have
  /// it any more, or have several of this name.
  std::optional<std::uint32_t> a = std::nullopt;
  std::optional<std::uint32_t> b = std::nullopt;
  std::optional<Vec3> place = std::nullopt;  ///< nothing where an older list has none
  Box box = {};                              ///< likewise empty
};

/// All rows of a report, in its order: those that were found, then those that are resolved.
class ListedClashes {
 public:
  /// `report` must stay.
  explicit ListedClashes(const ClashReport& report);

  [[nodiscard]] std::size_t size() const { return report_.rows.size() + report_.resolved.size(); }

  [[nodiscard]] ListedClash at(std::size_t k) const;

  [[nodiscard]] const ClashReport& report() const { return report_; }

 private:
  const ClashReport& report_;
  MarkedParts of_a_;  ///< of no use where nothing is resolved
  MarkedParts of_b_;
};

/// A text of a row or of one of its sides, or a number as text; empty where it has none.
[[nodiscard]] std::string text_of(const Json& row, std::string_view key);

/// What people call a side of a row: the path of its names, else the part's name, else its file.
[[nodiscard]] std::string side_label(const Json& row, std::string_view side);

}  // namespace soms::command
