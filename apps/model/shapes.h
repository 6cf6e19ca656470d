/// \file
/// Shapes named on the command line: built from models, or opened from tree files.
#pragma once

#include "soms/tree/file/shape_bytes.h"
#include "soms/tree/shape.h"

#include "apps/model/file_numbers.h"
#include "apps/model/models.h"

#include <string>

namespace soms::command {

class Console;

/// The shape of a model. A tree file is opened, with its hashes and indices checked. Its tree is
/// built again, with a note, where options change the mesh or where the canonical tree is needed.
/// \errors  As `read_model` and `build_shape`; ErrorKind::usage for options of trees that are not
///          those of the file.
[[nodiscard]] Shape load_shape(const std::string& path, const ModelOptions& model,
                               const ShapeOptions& shape, const Console& console);

/// The same of what `ModelOptions::parts` leaves of the model. Where it leaves out something, a
/// tree file is read as a model is.
/// \errors  As `load_shape`; ErrorKind::usage where nothing is left.
[[nodiscard]] ModelShape load_model_shape(const std::string& path, const ModelOptions& model,
                                          const ShapeOptions& shape, const Console& console);

/// The same where it is the only model of a verb: says how much is left.
/// \errors  As `load_model_shape` and `PartFilter::finish`.
[[nodiscard]] ModelShape load_only_model(const std::string& path, const ModelOptions& model,
                                         const ShapeOptions& shape, const Console& console);

/// Opens a tree file with a progress bar. `check` is how closely it is looked at.
/// \errors  As `open_shape`; ErrorKind::timed_out.
[[nodiscard]] Shape open_tree_file(const std::string& path, TreeCheck check,
                                   const Console& console);

}  // namespace soms::command
