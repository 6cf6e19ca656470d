/// \file
/// Who touches something, and when: bars over time, a row a body.
#pragma once

#include "apps/report/scene.h"

#include <cstddef>
#include <string>

namespace soms::report {

/// An SVG picture of the contacts of the `most_rows` bodies that touch something for longest, in
/// order of their first contact; empty where there is one step only or no contact. Bars name the
/// contact that they begin with: data-contact="12".
[[nodiscard]] std::string time_line(const Scene& scene, std::size_t most_rows = 40);

}  // namespace soms::report
