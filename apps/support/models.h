/// \file
/// Models named on the command line, from their files to shapes.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/query/traversal_options.h"
#include "soms/tree/build_options.h"
#include "soms/tree/shape.h"

#include <string>

namespace CLI {
class App;
}  // namespace CLI

namespace soms::command {

class Console;

/// How one model is read.
struct ModelOptions {
  double scale = 1;
  UpAxis up = UpAxis::unknown;  ///< turned from this axis to z; unknown: not turned
  bool allow_empty = false;
  bool offers_empty = false;  ///< the verb has --allow-empty, which a message may name
};

/// Adds options named `scale_name` and `up_name` ("--scale", "--up").
void add_model_options(CLI::App& app, ModelOptions& options, const std::string& scale_name,
                       const std::string& up_name, const std::string& whose);

/// Adds --allow-empty.
void add_allow_empty(CLI::App& app, ModelOptions& options);

/// Adds --rule, --levels, --leaf and the thesis' options of a build.
void add_build_options(CLI::App& app, BuildOptions& options);

/// \errors ErrorKind::usage, in words of the command, for options of a build that do not go
/// together.
void check_build(const BuildOptions& options);

/// Adds --traversal and --descent.
void add_traversal_options(CLI::App& app, TraversalOptions& options);

/// \errors ErrorKind::usage for a --descent that the traversal does not have.
void check_traversal(const CLI::App& app, const TraversalOptions& options);

/// Reads a model with a progress bar, scales and turns it. "-" is standard input.
/// \errors As `read_mesh`; ErrorKind::timed_out.
[[nodiscard]] Mesh read_model(const std::string& path, const ModelOptions& options,
                              const Console& console);

/// Builds a shape with a progress bar.
/// \errors As `Shape`; ErrorKind::timed_out.
[[nodiscard]] Shape build_shape(Mesh mesh, const ShapeOptions& options, const Console& console);

/// The part that triangle `i` belongs to, as the file calls it; empty where it names none.
/// \cost O(p) for p parts; PartsOf with `part_named` is for many triangles.
[[nodiscard]] std::string part_name(const Mesh& mesh, TriangleId i);

/// The name of a part as the file calls it; empty where it has none, and for Part::kNoParent.
[[nodiscard]] std::string part_named(const Mesh& mesh, std::uint32_t part);

}  // namespace soms::command
