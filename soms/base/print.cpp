#include "soms/base/print.h"

#include "soms/base/box.h"
#include "soms/base/bracket.h"
#include "soms/base/error.h"
#include "soms/base/pose.h"
#include "soms/base/print_fields.h"

namespace soms {

namespace {

/// "(1, 2, 0.1)".
std::string point(const Vec3& v) {
  std::string text = "(";
  text += shortest(v.x);
  text += ", ";
  text += shortest(v.y);
  text += ", ";
  text += shortest(v.z);
  text += ")";
  return text;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Vec3& value) {
  return out << PrintedFields("Vec3")
                    .item(shortest(value.x))
                    .item(shortest(value.y))
                    .item(shortest(value.z));
}

std::ostream& operator<<(std::ostream& out, const Triangle& value) {
  return out << PrintedFields("Triangle")
                    .item(point(value.a))
                    .item(point(value.b))
                    .item(point(value.c));
}

std::ostream& operator<<(std::ostream& out, const Box& value) {
  if (value == Box{}) {
    return out << PrintedFields("Box").item("empty");
  }
  return out << PrintedFields("Box").item(point(value.lower) + " to " + point(value.upper));
}

std::ostream& operator<<(std::ostream& out, const Bracket& value) {
  return out << PrintedFields("Bracket").add("lower", value.lower).add("upper", value.upper);
}

std::ostream& operator<<(std::ostream& out, const Pose& value) {
  PrintedFields rows("Pose");
  for (std::size_t i = 0; i < 12; i += 4) {
    rows.item(shortest(value.m[i]) + " " + shortest(value.m[i + 1]) + " " +
              shortest(value.m[i + 2]) + " " + shortest(value.m[i + 3]));
  }
  return out << rows;
}

std::ostream& operator<<(std::ostream& out, const Error& value) {
  return out << PrintedFields("Error").item(name(value.kind())).item(quoted_text(value.what()));
}

}  // namespace soms
