/// \file
/// All claims at a glance: claim by reading, in colored cells.
#pragma once

#include "thesis/page/report.h"

#include <string>

namespace soms::reproduce {

/// The picture with which the page begins, as SVG: a row for each claim of the run with its
/// verdicts, and a cell for each line of its matrix, a reading by a metric on all subjects. A cell
/// has a color and a sign: every judged row holds, some, none, undecided, or none is judged. Those
/// of the reading nearest to the text come first and are framed. Words stand behind the links. It
/// is there twice, for wide screens and for narrow ones. Empty if no claim was tested.
[[nodiscard]] std::string claims_overview(const Report& report);

}  // namespace soms::reproduce
