#include "thesis/claims/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace soms::reproduce {

namespace {

const Experiment* experiment_of(std::span<const Experiment> experiments, std::string_view item) {
  const auto found =
      std::find_if(experiments.begin(), experiments.end(),
                   [&](const Experiment& experiment) { return experiment.item == item; });
  return found == experiments.end() ? nullptr : &*found;
}

/// Numbers that a chapter of the thesis has: 1 to `last`.
struct Run {
  ThesisItemKind kind;
  int chapter;
  int last;
};

/// \source thesis, list of tables and list of figures.
constexpr std::array kRuns{
    Run{ThesisItemKind::table, 2, 2},   Run{ThesisItemKind::table, 3, 3},
    Run{ThesisItemKind::table, 5, 11},  Run{ThesisItemKind::figure, 2, 23},
    Run{ThesisItemKind::figure, 3, 9},  Run{ThesisItemKind::figure, 4, 44},
    Run{ThesisItemKind::figure, 5, 10},
};

std::vector<std::string> faults_of_numbers(std::span<const ThesisItem> items) {
  std::vector<std::string> faults;
  std::set<std::string> names;
  for (const ThesisItem& item : items) {
    if (!names.insert(item_name(item)).second) {
      faults.push_back(item_name(item) + " is listed twice");
    }
  }
  std::set<std::string> wanted;
  for (const Run& run : kRuns) {
    for (int k = 1; k <= run.last; ++k) {
      const std::string number = fmt::format("{}.{}", run.chapter, k);
      wanted.insert(item_name({.kind = run.kind, .number = number, .subject = {}}));
    }
  }
  for (const std::string& name : wanted) {
    if (!names.contains(name)) {
      faults.push_back(name + " is missing");
    }
  }
  for (const std::string& name : names) {
    if (!wanted.contains(name)) {
      faults.push_back(name + " is not in the thesis");
    }
  }
  return faults;
}

/// What is wrong with one item; empty if nothing is.
std::string fault_of(const ThesisItem& item, std::span<const Experiment> experiments) {
  const std::string name = item_name(item);
  const bool own = experiment_of(experiments, name) != nullptr;
  const int ways =
      (own ? 1 : 0) + (item.elsewhere.empty() ? 0 : 1) + (item.why_not.empty() ? 0 : 1);
  if (item.subject.empty()) {
    return name + " has no subject";
  }
  if (ways == 0) {
    return name + " is neither shown nor explained";
  }
  if (ways > 1) {
    return name + " is both shown and explained";
  }
  if (!item.elsewhere.empty() && experiment_of(experiments, item.elsewhere) == nullptr) {
    return fmt::format("{} refers to {}, which is not an item", name, item.elsewhere);
  }
  return {};
}

}  // namespace

std::string item_name(const ThesisItem& item) {
  return fmt::format("{}-{}", item.kind == ThesisItemKind::table ? "table" : "figure", item.number);
}

std::vector<Coverage> coverage(std::span<const ThesisItem> items,
                               std::span<const Experiment> experiments) {
  std::vector<Coverage> result;
  for (const ThesisItem& item : items) {
    Coverage& entry = result.emplace_back(Coverage{.item = &item});
    entry.experiment = experiment_of(experiments, item_name(item));
    if (entry.experiment != nullptr) {
      entry.state = CoverageState::shown;
      continue;
    }
    entry.experiment = experiment_of(experiments, item.elsewhere);
    entry.state = entry.experiment == nullptr ? CoverageState::not_shown : CoverageState::elsewhere;
  }
  return result;
}

std::vector<std::string> coverage_faults(std::span<const ThesisItem> items,
                                         std::span<const Experiment> experiments) {
  std::vector<std::string> faults = faults_of_numbers(items);
  for (const ThesisItem& item : items) {
    if (std::string fault = fault_of(item, experiments); !fault.empty()) {
      faults.push_back(std::move(fault));
    }
  }
  for (const Experiment& experiment : experiments) {
    const bool listed = std::any_of(items.begin(), items.end(), [&](const ThesisItem& item) {
      return item_name(item) == experiment.item;
    });
    if (experiment.chapter == Chapter::thesis && !listed) {
      faults.push_back(fmt::format("{} is not among the items of the thesis", experiment.item));
    }
  }
  return faults;
}

}  // namespace soms::reproduce
