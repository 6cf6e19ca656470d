/// \file
/// The verb `build`: saves a model with its tree, to be opened without being read or built again.
#pragma once

#include "soms/tree/shape.h"

#include "apps/cli/verb.h"
#include "apps/model/models.h"
#include "apps/output/json.h"

#include <string>

namespace soms::command {

/// Options of the verb `build`.
struct BuildVerbOptions {
  std::string input;
  std::string output;
  ModelOptions model;
  ShapeOptions shape;
  bool compact = false;
};

[[nodiscard]] Action add_build(Parser& parser, Shared& shared);
[[nodiscard]] int run_build(const BuildVerbOptions& options, Console& console);

/// A tree file in words: "city.somst: 1,000,000 triangles, 109.7 MB; rule fast, at most 8 triangles
/// a leaf".
[[nodiscard]] std::string describe_tree_file(const std::string& path, const Shape& shape);

/// What a tree file has beside its mesh, for JSON: bytes, hash, layout, and the options of its
/// tree.
[[nodiscard]] Json tree_file_json(const std::string& path, const Shape& shape);

}  // namespace soms::command
