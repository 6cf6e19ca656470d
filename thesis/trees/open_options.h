/// \file
/// Options that the thesis leaves open, as readings of its claims.
#pragma once

#include "soms/tree/build_options.h"
#include "soms/tree/statistics.h"

#include "thesis/trips/models.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// What a count may depend on and the thesis does not settle.
struct OpenOptions {
  AxisFrom soms_axis = AxisFrom::inner;  ///< of SOMS; the other rules keep that of the outer box
  EmptySide empty_side = EmptySide::stop;
  Midpoint midpoint = Midpoint::thesis;
};

/// What can become of a node whose rule leaves one side empty. `chain` has the leaves of `stop`.
inline constexpr std::array kEmptySides{EmptySide::stop, EmptySide::next_axis,
                                        EmptySide::object_median};

/// Both axes of SOMS: "between the midpoints" (both abstracts), and that of spatial median.
inline constexpr std::array kSomsAxes{AxisFrom::inner, AxisFrom::outer};

/// How the readings in a matrix are to be read, for the page.
inline constexpr std::string_view kReadingWords =
    " A reading names what becomes of a node that a rule cannot divide (the empty side) and the "
    "axis of SOMS. Empty side chain, which makes the nodes of table 5.5's \"No Triangle\", is no "
    "reading of its own here: its leaves hold what those of stop hold.";

/// Why a row with this axis of SOMS is shown and not judged; empty for the inner one.
/// \source thesis, abstract in Malay: "paksi terpanjang yang dikira antara titik tengah
///         segitiga-segitiga" (the longest axis, computed between the midpoints of the triangles).
[[nodiscard]] std::string axis_unjudged(AxisFrom soms_axis);

/// The thesis' options for a rule at a level, with these in the place of what is open.
[[nodiscard]] BuildOptions options_of(Rule rule, int level, const OpenOptions& open);

/// "stop" and "stop, inner axis": the reading in a row of a claim; `kReadingWords` explains it.
[[nodiscard]] std::string words_of(EmptySide empty_side);
[[nodiscard]] std::string words_of(EmptySide empty_side, AxisFrom soms_axis);

/// A model with the greatest level that the thesis has for its kind.
struct Leveled {
  const Model* model = nullptr;
  int level = 0;
};

/// All objects at level 15 and all scenes at level 13. \source thesis, tables 5.3 and 5.9.
[[nodiscard]] std::vector<Leveled> at_greatest_level(const Models& models);

/// Counts of a mesh's tree by a rule. \errors ErrorKind::cancelled.
[[nodiscard]] TreeStatistics counts_of(const Mesh& mesh, Rule rule, int level,
                                       const OpenOptions& open, const Limits& limits);

}  // namespace soms::reproduce
