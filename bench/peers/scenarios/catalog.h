/// \file
/// All scenes that can be requested.
#pragma once

#include "bench/peers/scenarios/scene.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace soms::bench {

/// A scene that can be made.
struct Offer {
  std::string scene;
  std::uint64_t triangles = 0;  ///< of the fixed body, or boxes; 0: as many as the file has
  bool quick = false;           ///< part of the short selection
  std::function<Scene()> make;
};

/// The generated scenes, and those of the models and cities in folder `data` (as SOMS_DATA is laid
/// out); an empty path leaves these out. `seed` is that of poses, points and rays.
[[nodiscard]] std::vector<Offer> catalog(const std::filesystem::path& data, std::uint64_t seed);

}  // namespace soms::bench
