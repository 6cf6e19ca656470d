/// \file
/// Reads CityJSON and sequences of CityJSON features (CityJSONSeq).
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/source.h"

#include <string_view>

namespace soms::detail {

/// True for an object whose type is CityJSON, alone or as the first line of a sequence.
[[nodiscard]] bool is_cityjson(std::string_view bytes);

/// A mesh with a part for each city object: its key is name and id. Objects come in the order of
/// their keys, those that others are parts of with these in them. Of an object's geometries the
/// most detailed one is read.
/// \errors As `read_mesh`.
/// \source CityJSON 2.0.1, https://www.cityjson.org/specs/2.0.1/
[[nodiscard]] Mesh read_cityjson(Source& source);

}  // namespace soms::detail
