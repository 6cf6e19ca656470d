/// \file
/// Models named on the command line, from their files to shapes.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/tree/build_options.h"
#include "soms/tree/shape.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace soms::command {

class Console;
class Parser;
class PartFilter;

/// How one model is read.
struct ModelOptions {
  double scale = 1;
  UpAxis up = UpAxis::unknown;  ///< turned from this axis to z; unknown: not turned
  std::string crs = {};         ///< of the scaled and turned coordinates; empty: as the file says
  bool scale_is_given = false;  ///< `scale`, 1 too, is the user's word about the unit
  bool strict = false;          ///< notes about what the file lacks or has too much are errors
  bool allow_empty = false;
  bool offers_empty = false;  ///< the verb has --allow-empty, which a message may name
  bool lists_notes = false;   ///< the verb prints the notes of the mesh itself
  std::optional<double> lod = std::nullopt;  ///< as ReadOptions
  bool surfaces = false;                     ///< as ReadOptions
  /// --only and --ignore of the verb, for what takes the model apart; may be none.
  std::shared_ptr<PartFilter> parts = nullptr;
};

/// Adds options named `scale_name` and `up_name` ("--scale", "--up"); beside "--up" and "--up-b" of
/// models that stay where they are, --crs with the same suffix.
void add_model_options(Parser& parser, ModelOptions& options, const std::string& scale_name,
                       const std::string& up_name, const std::string& whose);

/// Adds --lod and --surfaces, with a suffix ("-b") for the second of two models.
void add_city_options(Parser& parser, ModelOptions& options, const std::string& suffix,
                      const std::string& whose);

/// What --strict means.
inline constexpr const char* kStrictMeaning =
    "treat warnings and notes about a model as errors (exit status 3)";

/// Adds --strict, which a verb of two models also refuses `FrameWarning`s by.
void add_strict(Parser& parser, bool& strict);

/// Adds --allow-empty.
void add_allow_empty(Parser& parser, ModelOptions& options);

/// Adds --rule, --levels, --leaf and the thesis' options of a build.
void add_build_options(Parser& parser, BuildOptions& options);

/// Heading of the options of trees and of their traversals.
inline constexpr const char* kTreeGroup = "Trees (answers do not depend on these)";

/// Adds --tree, whose keys are the options of a build.
void add_tree_list(Parser& parser, BuildOptions& build);

/// \errors ErrorKind::usage, in words of the command, for options of a build that do not go
/// together, and for one that was given and has no effect beside the others.
void check_build(const Parser& parser, const BuildOptions& options);

/// Those options of `idle` that were given, by their names on the command line.
[[nodiscard]] std::vector<std::string> given_of(const Parser& parser,
                                                const std::vector<IdleOption>& idle);

/// \errors ErrorKind::usage for an option of `idle` that was given: it would change nothing.
void refuse_given(const Parser& parser, const std::vector<IdleOption>& idle);

/// The first option of trees or their traversal that was given; empty if none was.
[[nodiscard]] std::string given_of_trees(const Parser& parser);

/// \errors ErrorKind::usage for a folder of tiles, where whole surfaces are needed.
void refuse_tiles(const std::string& path);

/// Reads a model with a progress bar, scales and turns it. "-" is standard input. Its notes go to
/// standard error, unless `lists_notes`.
/// \errors As `read_mesh`; ErrorKind::timed_out.
[[nodiscard]] Mesh read_model(const std::string& path, const ModelOptions& options,
                              const Console& console);

/// The same of the only model of a verb, less the parts that `ModelOptions::parts` leaves out. Says
/// how much is left.
[[nodiscard]] Mesh read_only_model(const std::string& path, const ModelOptions& options,
                                   const Console& console);

/// What `read_model` says of a mesh that was not read: the limits of a verb, and notes.
/// \errors ErrorKind::empty_mesh, usage; with --strict bad_file for a note.
void check_statements(const MeshView& mesh, const ModelOptions& options, const std::string& path,
                      const Console& console);

/// What reading left out of the meshes or did not apply, "FILE: NOTE", each once.
[[nodiscard]] std::vector<std::string> notes_of(std::span<const MeshView> meshes);

/// Builds a shape with a progress bar.
/// \errors As `Shape`; ErrorKind::timed_out.
[[nodiscard]] Shape build_shape(Mesh mesh, const ShapeOptions& options, const Console& console);

/// The part that triangle `i` belongs to, as the file calls it; empty where it names none.
/// \cost O(p) for p parts; PartsOf with `part_named` is for many triangles.
[[nodiscard]] std::string part_name(const MeshView& mesh, TriangleId i);

/// The name of a part as the file calls it; empty where it has none, and for Part::kNoParent.
[[nodiscard]] std::string part_named(const MeshView& mesh, std::uint32_t part);

}  // namespace soms::command
