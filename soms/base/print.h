/// \file
/// Values of this room, and errors, printed by `<<`: "Vec3{1, 2, 0.1}".
#pragma once

#include <iosfwd>

namespace soms {

class Error;
enum class ErrorKind;
enum class Rotation;
struct Box;
struct Bracket;
struct Pose;
struct Triangle;
struct Vec3;

/// One line, whatever the flags, precision and locale of the stream; a set width pads it. Numbers
/// have the fewest digits from which the same double is read.
std::ostream& operator<<(std::ostream& out, const Vec3& value);
std::ostream& operator<<(std::ostream& out, const Triangle& value);
std::ostream& operator<<(std::ostream& out, const Box& value);
std::ostream& operator<<(std::ostream& out, const Bracket& value);
std::ostream& operator<<(std::ostream& out, const Pose& value);
std::ostream& operator<<(std::ostream& out, Rotation value);
std::ostream& operator<<(std::ostream& out, ErrorKind value);
std::ostream& operator<<(std::ostream& out, const Error& value);

}  // namespace soms
