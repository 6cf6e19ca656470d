/// \file
/// Facets as few SVG paths: those of one color share a path wherever the order of painting allows.
#pragma once

#include "thesis/pictures/projection.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace soms::reproduce {

/// A path of facets of one color, in tenths of pixels.
struct FacetPath {
  std::string fill;
  std::string data;
  bool outlined = true;  ///< edges of triangles, not cuts through one
};

/// Facets in painter's order as paths in painter's order.
[[nodiscard]] std::vector<FacetPath> facet_paths(std::span<const Facet> facets);

/// Paths of as many facets as were requested.
struct FittedPaths {
  std::vector<FacetPath> paths;
  std::size_t drawn = 0;  ///< facets in them
};

/// The same within about so many bytes: of too many facets those that show least are left out.
[[nodiscard]] FittedPaths paths_within(std::vector<Facet> facets, std::size_t bytes);

/// Fill of a drawn color in one of few brightnesses, as #rrggbb.
[[nodiscard]] std::string shade_of(int color, double brightness);

}  // namespace soms::reproduce
