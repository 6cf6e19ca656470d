/// \file
/// Formats and the options of reading, printed by `<<`: "ReadOptions{allow_empty: false, ...}".
#pragma once

#include "soms/io/write_mesh.h"

#include <iosfwd>

namespace soms {

struct Column;
struct CrsAxes;
struct ReadOptions;
struct ReadableFormat;
struct RobotReadOptions;
struct Rounding;
struct WritableFormat;

/// One line, as in soms/base/print.h.
std::ostream& operator<<(std::ostream& out, const Column& value);
std::ostream& operator<<(std::ostream& out, const CrsAxes& value);
std::ostream& operator<<(std::ostream& out, const ReadOptions& value);
std::ostream& operator<<(std::ostream& out, const ReadableFormat& value);
std::ostream& operator<<(std::ostream& out, const RobotReadOptions& value);
std::ostream& operator<<(std::ostream& out, const WritableFormat& value);
std::ostream& operator<<(std::ostream& out, const Rounding& value);

}  // namespace soms
