/// \file
/// A page about a list of pairs of parts: a table of all rows, and a view of the parts that shows
/// the row that is chosen.
#pragma once

#include "apps/report/page.h"
#include "apps/report/parts_data.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace soms::report {

/// From where a row is seen.
struct PageSight {
  Vec3 place = {};   ///< where the two meet, or are nearest
  Vec3 focus = {};   ///< what the camera looks at
  double reach = 1;  ///< radius around `focus` that is worth seeing
  Vec3 toward = {};  ///< unit vector from `focus` to the eye
  bool a_is_larger = false;
};

/// A row of the list.
struct PageRow {
  std::string json = {};  ///< an object with numbers of sides as "a" and "b", and all that is known
  std::optional<PageSight> sight = std::nullopt;
  std::vector<std::array<Vec3, 2>> lines = {};  ///< along which the surfaces cross
};

/// A part that rows name.
struct PageSide {
  std::string json = {};       ///< an object: its file, names, id and what else is known
  std::size_t part = kNoPart;  ///< in `PartsPage::parts`; kNoPart for one that the models lack
};

/// All that the page says. `page.scene` and `page.plots` are not used.
struct PartsPage {
  Page page;
  std::string totals = "{}";  ///< an object of JSON that counts the rows
  std::vector<PagePart> parts = {};
  std::vector<PageSide> sides = {};
  std::size_t rows = 0;
  /// Gives row k; called once for each, in order.
  std::function<PageRow(std::size_t k)> row = {};
};

/// Writes the page, every row in it. What of the parts found no room is said on it.
/// \errors Those of `page.row`.
ShownParts write_parts_page(std::ostream& out, const PartsPage& page,
                            const SceneLimits& limits = {});

}  // namespace soms::report
