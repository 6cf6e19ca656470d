/// \file
/// A shape as JavaScript holds it, with what is found once and used by later queries.
#pragma once

#include "soms/query/contains.h"
#include "soms/tree/shape.h"

#include <optional>
#include <utility>

namespace soms::web {

/// A shape, and that it is closed once that was needed.
class HeldShape {
 public:
  explicit HeldShape(Shape shape) : shape_(std::move(shape)) {}

  [[nodiscard]] const Shape& shape() const { return shape_; }

  /// \errors As `ClosedBody`.
  [[nodiscard]] ClosedBody closed_at(const Pose& pose) {
    if (!closed_) {
      closed_.emplace(Body(shape_, pose));
    }
    return closed_->body().pose == pose ? *closed_ : closed_->at(pose);
  }

 private:
  Shape shape_;
  std::optional<ClosedBody> closed_;  ///< at the first pose that was needed
};

}  // namespace soms::web
