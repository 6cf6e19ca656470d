/// \file
/// Features of 3D Tiles and glTF: what a table of properties says of an object.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace soms::detail {

/// An object as its row of a table describes it.
struct Feature {
  std::string name;
  std::string id;
  std::string type;
  std::vector<Attribute> attributes;
};

/// The feature that has these columns: its id is that of the first column with a customary name of
/// ids ("id", "gml:id", "guid"), else its number; its name that of "name", else its id; its type
/// that of "type" or "class". Columns stay among the attributes.
[[nodiscard]] Feature feature_of(std::vector<Attribute> columns, std::uint64_t number);

}  // namespace soms::detail
