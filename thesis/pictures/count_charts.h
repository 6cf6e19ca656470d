/// \file
/// Charts of counted trees.
#pragma once

#include "apps/draw/chart.h"
#include "thesis/run/counts.h"

#include <span>
#include <string>

namespace soms::reproduce {

/// A number of a counted tree.
using CountValue = double (*)(const Counted&);

/// Triangles alone in a leaf, in percent of all.
[[nodiscard]] double one_percent(const Counted& counted);

/// Leaves with fewer than five triangles, in percent of all that hold one.
[[nodiscard]] double lt5_percent(const Counted& counted);

/// Leaves with fewer than five triangles.
[[nodiscard]] double lt5(const Counted& counted);

/// Balanced level.
[[nodiscard]] double balanced_level(const Counted& counted);

/// Nodes whose rule left one side empty.
[[nodiscard]] double undividable(const Counted& counted);

/// Bars of all counts as SVG: a group for each model, a bar for each contender.
[[nodiscard]] std::string bars_of(std::string title, std::string y_label,
                                  std::span<const Counted> counts, CountValue value,
                                  Scale scale = Scale::linear);

/// Lines over the greatest level as SVG, one for each contender with the usual options, of the
/// counts of one model. Builds without a limit of levels have no line.
[[nodiscard]] std::string lines_by_level(std::string title, std::string y_label, const Model& model,
                                         std::span<const Counted> counts, CountValue value);

/// Those with the usual options.
[[nodiscard]] std::vector<Counted> with_usual_options(std::span<const Counted> counts);

}  // namespace soms::reproduce
