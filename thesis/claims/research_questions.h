/// \file
/// The research questions of the thesis (section 1.2), each answered from a run.
#pragma once

#include "thesis/page/report.h"

#include <string>

namespace soms::reproduce {

/// The section of the page that has all seven: the question in our words, the answer in a few
/// sentences, and links to the items that have its tables. An answer says only what the text
/// states or what this run counted or timed; where an item did not run, it says less.
[[nodiscard]] std::string questions_section(const Report& report);

}  // namespace soms::reproduce
