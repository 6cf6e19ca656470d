/// \file
/// Options of what is generated, cities and routes, printed by `<<`.
#pragma once

#include <iosfwd>

namespace soms {

enum class MoverKind;
enum class UrbanScene;
struct City;
struct CityOptions;
struct Route;
struct SpreadOptions;

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const City& value);
std::ostream& operator<<(std::ostream& out, const CityOptions& value);
std::ostream& operator<<(std::ostream& out, const Route& value);
std::ostream& operator<<(std::ostream& out, const SpreadOptions& value);
std::ostream& operator<<(std::ostream& out, MoverKind value);
std::ostream& operator<<(std::ostream& out, UrbanScene value);

}  // namespace soms
