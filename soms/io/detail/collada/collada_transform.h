/// \file
/// The transforms of COLLADA's nodes.
#pragma once

#include "soms/io/detail/affine.h"
#include "soms/io/detail/collada/collada_document.h"

namespace soms::detail {

/// The matrix in an element of 16 numbers, row by row.
/// \errors ErrorKind::bad_file, not_finite, unsupported (its last row is not 0 0 0 1).
[[nodiscard]] Affine read_matrix(const ColladaDocument& document, pugi::xml_node element);

/// The product of all transforms that are children of a node, in their order: the last one meets
/// the vertices first. \errors as of `read_matrix`; axes of no length are bad_file.
[[nodiscard]] Affine read_transforms(const ColladaDocument& document, pugi::xml_node node);

}  // namespace soms::detail
