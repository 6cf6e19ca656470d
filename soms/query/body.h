/// \file
/// A shape at a place.
#pragma once

#include "soms/base/pose.h"
#include "soms/tree/shape.h"

#include <string>
#include <utility>

namespace soms {

/// A shape with a pose and a name, as queries take it. A value; copies share the shape.
struct Body {
  Shape shape = {};
  Pose pose = {};
  std::string name = {};

  Body() = default;

  explicit Body(Shape s, const Pose& p = {}, std::string n = {})
      : shape(std::move(s)), pose(p), name(std::move(n)) {}

  /// Builds a shape with default options.
  explicit Body(Mesh mesh, const Pose& p = {}) : shape(std::move(mesh)), pose(p) {}

  [[nodiscard]] bool operator==(const Body&) const = default;
};

}  // namespace soms
