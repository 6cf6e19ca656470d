/// \file
/// What a page says first of a scene: which of its rows is the worst, and who touches whom there.
#pragma once

#include "apps/report/scene.h"

#include <cstddef>
#include <optional>
#include <string>

namespace soms::report {

/// The row with the most pairs of triangles in a step, of equal ones that with the most contacts:
/// the first of the list as a page opens. Nothing where the scene has no rows.
[[nodiscard]] std::optional<std::size_t> worst_row(const Scene& scene);

/// "car 12 (hull) touches house_31", as the list of the page names the two of a row.
[[nodiscard]] std::string who_touches(const Scene& scene, const SceneRow& row);

}  // namespace soms::report
