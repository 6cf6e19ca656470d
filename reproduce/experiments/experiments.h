/// \file
/// The functions behind the table of experiments, one file each (or one for those of a kind).
#pragma once

#include "reproduce/experiment.h"

namespace soms::reproduce {

/// Objects of the thesis: vertices and faces of each PLY file. \source thesis, table 3.1.
[[nodiscard]] Result table_3_1(const Context& context);

}  // namespace soms::reproduce
