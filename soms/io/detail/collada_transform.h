/// \file
/// The transforms of COLLADA's nodes.
#pragma once

#include "soms/base/vector.h"
#include "soms/io/detail/collada_document.h"

#include <array>

namespace soms::detail {

/// Three rows of four: p' = ((m0 x + m1 y) + m2 z) + m3, likewise y' and z'.
struct Affine {
  std::array<double, 12> m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  [[nodiscard]] bool operator==(const Affine&) const = default;

  [[nodiscard]] Vec3 apply(const Vec3& p) const;
  /// True if it turns outlines around: its determinant is negative.
  [[nodiscard]] bool mirrors() const;
};

/// First `b`, then `a`.
[[nodiscard]] Affine operator*(const Affine& a, const Affine& b);

/// The matrix in an element of 16 numbers, row by row.
/// \errors ErrorKind::bad_file, not_finite, unsupported (its last row is not 0 0 0 1).
[[nodiscard]] Affine read_matrix(const ColladaDocument& document, pugi::xml_node element);

/// The product of all transforms that are children of a node, in their order: the last one meets
/// the vertices first. \errors as of `read_matrix`; axes of no length are bad_file.
[[nodiscard]] Affine read_transforms(const ColladaDocument& document, pugi::xml_node node);

}  // namespace soms::detail
