/// \file
/// Writing a model where -o or OUT says, whole or not at all.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/write_mesh.h"

#include <optional>
#include <string>

namespace soms::command {

class Console;
class Parser;

/// Where a model goes, and how.
struct ModelOutput {
  std::string path;                  ///< "-" is standard output
  std::optional<MeshFormat> format;  ///< unset: by the name, PLY for "-"
};

/// Adds --format.
void add_format(Parser& parser, ModelOutput& output);

/// The format to write. \errors ErrorKind::usage for a folder, for an unknown extension, naming
/// those that are offered, and for one that says another format than --format.
[[nodiscard]] MeshFormat format_of(const ModelOutput& output);

/// Throws ErrorKind::usage if there is no name, or if --json and the model would share standard
/// output.
void check(const ModelOutput& output, const Console& console);

/// Writes the model; tells of coordinates that become floats.
/// \errors As `write_mesh`; ClosedPipe.
void write_model(const MeshView& mesh, const ModelOutput& output, const Console& console);

/// Says in one line what of the model's unit, axis and names the format does not keep.
void note_losses(const MeshView& mesh, const ModelOutput& output, const Console& console);

/// Kebab-case name of a format.
[[nodiscard]] std::string format_name(MeshFormat format);

}  // namespace soms::command
