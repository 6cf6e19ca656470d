/// \file
/// Options of what is generated, cities and routes, printed by `<<`.
#pragma once

#include "soms/generate/shapes.h"
#include "soms/generate/urban.h"

#include <iosfwd>

namespace soms {

struct City;
struct CityOptions;
struct Route;
struct SpreadOptions;

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const City& value);
std::ostream& operator<<(std::ostream& out, const CityOptions& value);
std::ostream& operator<<(std::ostream& out, const Route& value);
std::ostream& operator<<(std::ostream& out, const SpreadOptions& value);

}  // namespace soms
