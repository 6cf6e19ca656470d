/// \file
/// Listings: pseudo code with numbered lines, and beside it what a run made of it.
#pragma once

#include "thesis/run/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// Ends the caption of a figure whose original is known only by its caption.
inline constexpr std::string_view kFromCaption =
    " From the caption; the thesis' own listing was not available to us.";

/// A line of pseudo code.
struct CodeLine {
  int indent = 0;
  std::string code = {};
  std::string example = {};  ///< what it did with the set that is shown; may be empty
};

/// Pseudo code, and either examples line by line or the steps of a run.
struct Listing {
  std::string title;
  std::vector<CodeLine> lines;
  std::string heading = {};  ///< above the examples or the steps: which set it is
  /// The steps of a run, as they are written as CSV; no columns: the examples are shown instead.
  const Table* steps = nullptr;
};

/// The listing as SVG: code at the left; examples, or steps if they fit, at its right, else below.
[[nodiscard]] std::string draw_listing(const Listing& listing);

/// The figure of a listing, which tells the code to who cannot see it.
[[nodiscard]] Figure listing_figure(std::string id, std::string caption, const Listing& listing);

/// Figure and table of a listing with steps, which is known by its caption.
[[nodiscard]] Result listing_result(const std::string& id, std::string caption, Listing listing,
                                    Table steps);

}  // namespace soms::reproduce
