/// \file
/// The verb `generate`: models of an exact number of triangles.
#pragma once

#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"

#include "apps/cli/verb.h"
#include "apps/soms/models/model_output.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace soms::command {

/// A kind of model: `make` takes the number of triangles (0: the kind's own) and the seed. A city
/// heeds the stop.
struct GenerateKind {
  std::string_view name;
  std::string_view text;  ///< one line of the help
  Mesh (*make)(std::uint64_t triangles, std::uint64_t seed, const Limits& limits);
};

/// All kinds, in the order of the help.
[[nodiscard]] std::span<const GenerateKind> generate_kinds();

/// Options of the verb `generate`.
struct GenerateOptions {
  const GenerateKind* kind = nullptr;
  std::uint64_t triangles = 0;  ///< 0: the kind's own number
  ModelOutput output;
};

[[nodiscard]] Action add_generate(Parser& parser, Shared& shared);
[[nodiscard]] int run_generate(const GenerateOptions& options, Console& console);

}  // namespace soms::command
