/// \file
/// Values of this room, and errors, printed by `<<`: "Vec3{1, 2, 0.1}".
#pragma once

#include "soms/base/error.h"
#include "soms/base/pose.h"
#include "soms/base/words.h"

#include <ostream>
#include <string>
#include <string_view>

namespace soms {

struct Box;
struct Bracket;
struct Triangle;
struct Vec3;

/// One line, whatever the flags, precision and locale of the stream; a set width pads it. Numbers
/// have the fewest digits from which the same double is read.
std::ostream& operator<<(std::ostream& out, const Vec3& value);
std::ostream& operator<<(std::ostream& out, const Triangle& value);
std::ostream& operator<<(std::ostream& out, const Box& value);
std::ostream& operator<<(std::ostream& out, const Bracket& value);
std::ostream& operator<<(std::ostream& out, const Pose& value);
std::ostream& operator<<(std::ostream& out, const Error& value);

/// The word of a value; "Side(7)" where it has none.
template <Worded E>
std::ostream& operator<<(std::ostream& out, E value) {
  const std::string_view word = name(value);
  return out << (word.empty() ? std::string(kWords<E>.type) + "(" +
                                    std::to_string(static_cast<long long>(value)) + ")"
                              : std::string(word));
}

}  // namespace soms
