/// \file
/// What the lengths of a scene are called.
#pragma once

#include "soms/query/body.h"

#include <span>
#include <string>

namespace soms::command {

/// Meters a unit, where the models of all these bodies declare the same; else 0.
[[nodiscard]] double common_unit(std::span<const Body> bodies);

/// What a unit of so many meters is called: "m", "mm", "ft"; "units" for one that is not known.
[[nodiscard]] std::string unit_name(double meters);

/// A length with its unit, whole kilometers as such: "20 m", "5 km", "20 units".
[[nodiscard]] std::string length_with_unit(double length, double meters_a_unit);

}  // namespace soms::command
