/// \file
/// Every table and figure of the thesis: which item shows it, or why none does.
#pragma once

#include "thesis/run/experiment.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// Tables and figures in the lists at the front of the thesis.
inline constexpr std::size_t kThesisTables = 16;
inline constexpr std::size_t kThesisFigures = 86;

enum class ThesisItemKind { table, figure };

/// A table or figure of the thesis. The experiment of its own number ("figure-4.30") shows it;
/// where there is none, `elsewhere` or `why_not` is set, never both.
struct ThesisItem {
  ThesisItemKind kind = ThesisItemKind::figure;
  std::string_view number;          ///< "4.30"
  std::string_view subject;         ///< what it is about, in our words
  std::string_view elsewhere = {};  ///< item of another number that shows the same subject
  std::string_view why_not = {};    ///< one sentence, if nothing shows it
};

/// All of them in the order of the thesis: tables, then figures.
/// \source  thesis, list of tables and list of figures.
[[nodiscard]] std::span<const ThesisItem> thesis_items();

/// "table-5.3": the item of this number, if there is an experiment for it.
[[nodiscard]] std::string item_name(const ThesisItem& item);

/// How a table or figure of the thesis stands.
enum class CoverageState {
  shown,      ///< an item of its own
  elsewhere,  ///< another item shows the same subject
  not_shown,
};

/// A table or figure of the thesis, joined with the experiments.
struct Coverage {
  const ThesisItem* item = nullptr;
  CoverageState state = CoverageState::not_shown;
  const Experiment* experiment = nullptr;  ///< that shows it; nullptr if none does
};

/// Joins each of `items` with the experiment that shows it. \shape one entry for each item.
[[nodiscard]] std::vector<Coverage> coverage(std::span<const ThesisItem> items,
                                             std::span<const Experiment> experiments);

/// What contradicts itself, one sentence each: a number that is missing or double, an item that is
/// shown and has a reason why not, one that is neither, an `elsewhere` that is no experiment, an
/// experiment of Chapter::thesis that is not among the items. Empty if all is well.
[[nodiscard]] std::vector<std::string> coverage_faults(std::span<const ThesisItem> items,
                                                       std::span<const Experiment> experiments);

}  // namespace soms::reproduce
