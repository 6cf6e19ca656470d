/// \file
/// Which nodes of a glTF file are shown, and where they stand.
#pragma once

#include "soms/io/detail/affine.h"
#include "soms/io/detail/json_document.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

/// By which a node says whether it and those within it are visible.
inline constexpr std::string_view kVisibility = "KHR_node_visibility";

/// A node of the scene.
struct PlacedNode {
  JsonValue json;
  std::uint32_t depth = 0;  ///< nodes that it is within
  Affine world;
  bool hidden = false;  ///< it, or a node that it is within, says that it is not visible
};

/// Nodes of the default scene, each before those within it, in the order of the file. The first
/// scene is taken where none is the default, and all nodes where there is no scene; `notes` says
/// so.
/// \errors ErrorKind::bad_file (a node within two, or within itself), out_of_memory, cancelled.
[[nodiscard]] std::vector<PlacedNode> place_nodes(Source& source, const JsonValue& root,
                                                  std::vector<std::string>& notes);

}  // namespace soms::detail
