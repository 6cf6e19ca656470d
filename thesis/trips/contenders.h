/// \file
/// The builds that are compared: the rules of the thesis with its options, and the library's beside
/// them.
#pragma once

#include "soms/tree/build_options.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// A build to compare.
struct Contender {
  std::string name;        ///< snake_case, as in the tables: "soms", "sah"
  std::string title;       ///< for legends: "SOMS"
  bool of_thesis = false;  ///< one of the four rules of the thesis
  BuildOptions options = {};
};

/// All that can become of a node whose rule leaves one side empty.
inline constexpr std::array kAllEmptySides{EmptySide::stop, EmptySide::next_axis,
                                           EmptySide::object_median, EmptySide::chain};

/// What `thesis_options` sets, for captions of tables and charts that have no columns for it.
inline constexpr std::string_view kThesisOptions =
    " Rules of the thesis with the thesis' options: midpoint thesis, axis of the outer box (SOMS: "
    "inner), empty side stop, C = 2.";

/// The options of `all_builds`, for captions of charts that show all of them.
inline constexpr std::string_view kComparedOptions =
    " Rules of the thesis with the thesis' options. SAH: to the same level and with one triangle a "
    "leaf, too, but midpoint aabb and empty side object_median. The library's default: rule fast, "
    "leaves of at most 8 triangles, no limit of levels.";

/// Object median, object mean, spatial median and SOMS with the thesis' options, in this order.
[[nodiscard]] std::vector<Contender> thesis_rules(int level);

/// The rules of the thesis, then SAH to the same level with one triangle a leaf, then the build
/// that the library itself uses, its fastest, with its own options (no limit of levels).
[[nodiscard]] std::vector<Contender> all_builds(int level);

}  // namespace soms::reproduce
