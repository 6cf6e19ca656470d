/// \file
/// The verb `clash`: which parts of models clash with each other.
#pragma once

#include "apps/cli/verb.h"
#include "apps/soms/clash/clash_files.h"
#include "apps/soms/clash/clash_models.h"
#include "apps/soms/clash/clash_sets.h"

#include <optional>
#include <string>
#include <vector>

namespace soms::command {

/// When the exit status says that there are clashes.
enum class ClashFailure : unsigned char {
  never,
  listed,  ///< any that is listed
  hard,    ///< interior is shared
  fresh,   ///< one that the older list does not have
};

/// Options of the verb `clash`.
struct ClashVerbOptions {
  ClashModelOptions models;
  ClashSetOptions sets;
  ClashGrouping grouping;
  std::optional<double> within;
  std::optional<double> tolerance;         ///< depth that nobody minds
  std::vector<std::string> ignored_kinds;  ///< names of ClashKind
  std::string ignored_pairs;               ///< file; empty: none
  bool ignore_siblings = false;            ///< parts of one object
  std::vector<std::string> statuses;       ///< that are listed; empty: all
  std::string baseline;                    ///< file; empty: none
  std::string journal;                     ///< file; empty: none
  std::vector<std::string> outputs;        ///< files
  ClashFileOptions files = {};
  ClashFailure fail_if = ClashFailure::never;
  bool verify = false;
};

[[nodiscard]] Action add_clash(Parser& parser, Shared& shared);
[[nodiscard]] int run_clash(const ClashVerbOptions& options, Console& console);

}  // namespace soms::command
