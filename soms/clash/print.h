/// \file
/// Clashes printed by `<<`: "Clash{0 and 3, touching, 18 pairs of triangles, ...}".
#pragma once

#include "soms/clash/clash.h"

#include <iosfwd>

namespace soms {

enum class ClashKind : unsigned char;
struct Clash;
struct ClashList;
struct OpenUnion;
struct PartBody;
struct PartComponent;
struct Penetration;

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const Clash& value);
std::ostream& operator<<(std::ostream& out, const ClashList& value);
std::ostream& operator<<(std::ostream& out, const OpenUnion& value);
std::ostream& operator<<(std::ostream& out, const PartBody& value);
std::ostream& operator<<(std::ostream& out, const PartComponent& value);
std::ostream& operator<<(std::ostream& out, const Penetration& value);

}  // namespace soms
