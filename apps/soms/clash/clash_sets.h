/// \file
/// Sets of parts, as disciplines of a building, and groups of clashes.
#pragma once

#include "soms/clash/clash.h"

#include "apps/soms/clash/clash_models.h"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

/// Whether something holds of a part of the first body and one of the second, for all that the two
/// sides of a clash stand for: of open groups (`body_in`), for every part.
[[nodiscard]] bool of_all_parts(const ClashModels& models, const Clash& clash,
                                const std::function<bool(std::uint32_t, std::uint32_t)>& holds);

/// True if a pattern of a shell (* ? [a-z]) fits the path of a part's names, its own name, or its
/// id; of a body of several parts, those of one of them.
[[nodiscard]] bool is_called(const ClashSet& set, std::uint32_t part, const std::string& pattern);

/// Which set a part belongs to, and which sets are compared.
struct ClashSetOptions {
  std::vector<std::pair<std::string, std::string>> patterns;  ///< name of a set, and a pattern
  std::vector<std::pair<std::string, std::string>> between;   ///< names of sets; empty: all
};

/// "NAME=PATTERN". \errors ErrorKind::usage where a half of it is missing.
[[nodiscard]] std::pair<std::string, std::string> set_pattern(const std::string& text);

/// "NAME,NAME". \errors As `set_pattern`.
[[nodiscard]] std::pair<std::string, std::string> set_pair(const std::string& text);

/// Gives each part the first set whose pattern fits its names, its type or its file; else that
/// which is named as its file, without folder and extension.
/// \errors ErrorKind::usage for a pattern that fits no part, or no part that is left, and for a set
///         of `between` that no part belongs to.
void give_sets(const ClashSetOptions& options, ClashModels& models);

/// True if the options want these parts compared.
[[nodiscard]] bool are_compared(const ClashSetOptions& options, const ClashModels& models,
                                std::uint32_t a, std::uint32_t b);

/// True if `are_compared`, or the bodies that the two lead (`body_in`) have parts that are: an open
/// group may be of several sets.
[[nodiscard]] bool bodies_are_compared(const ClashSetOptions& options, const ClashModels& models,
                                       std::uint32_t a, std::uint32_t b);

/// True of a clash of bodies, and of parts if they are compared.
[[nodiscard]] bool is_looked_for(const ClashSetOptions& options, const ClashModels& models,
                                 const Clash& clash);

/// What clashes are grouped by.
enum class ClashGroup : unsigned char {
  none,
  a,       ///< the first part
  b,       ///< the second part
  parent,  ///< the object that holds the first part: its storey, as a rule
  type,    ///< the types of both
  set,     ///< the sets of both
  cell,    ///< the cell of a grid in which the place lies
};

struct ClashGrouping {
  ClashGroup by = ClashGroup::none;
  double cell = 0;  ///< side of a cell, in the unit of the models
};

/// "a", "b", "parent", "type", "set", or "cell=SIZE". \errors ErrorKind::usage.
[[nodiscard]] ClashGrouping clash_grouping(const std::string& text);

/// True if one object holds both parts, or one of the parts holds the other.
[[nodiscard]] bool are_siblings(const ClashModels& models, const Clash& clash);

/// The groups of clashes.
class ClashGroups {
 public:
  /// Both must stay.
  ClashGroups(const ClashGrouping& grouping, const ClashModels& models);

  /// The group of a clash; "-" where it has none.
  [[nodiscard]] std::string operator()(const Clash& clash) const;

 private:
  const ClashGrouping& grouping_;
  const ClashModels& models_;
  std::vector<std::string> labels_;  ///< of each part, where parts or their objects are groups
};

}  // namespace soms::command
