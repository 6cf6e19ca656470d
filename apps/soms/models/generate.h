/// \file
/// The verb `generate`: models of an exact number of triangles.
#pragma once

#include "soms/base/limits.h"
#include "soms/generate/city.h"
#include "soms/geometry/mesh.h"

#include "apps/cli/verb.h"
#include "apps/soms/models/model_output.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace soms::command {

/// What a model is made by; only cities heed the last two.
struct GenerateWish {
  std::uint64_t triangles = 0;  ///< 0: the kind's own number
  std::uint64_t seed = 1;
  double extent = 0;  ///< side of a city's square; 0: as its triangles fill
  std::optional<CityStreets> streets = std::nullopt;  ///< none: paved
};

/// A kind of model. A city heeds the stop.
struct GenerateKind {
  std::string_view name;
  std::string_view text;  ///< one line of the help
  Mesh (*make)(const GenerateWish& wish, const Limits& limits);
};

/// All kinds, in the order of the help.
[[nodiscard]] std::span<const GenerateKind> generate_kinds();

/// Options of the verb `generate`.
struct GenerateOptions {
  const GenerateKind* kind = nullptr;
  GenerateWish wish = {};
  ModelOutput output;
};

[[nodiscard]] Action add_generate(Parser& parser, Shared& shared);
[[nodiscard]] int run_generate(const GenerateOptions& options, Console& console);

}  // namespace soms::command
