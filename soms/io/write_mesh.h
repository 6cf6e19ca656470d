/// \file
/// Writing models: PLY, OBJ, STL, OFF.
#pragma once

#include "soms/base/parallel.h"
#include "soms/geometry/mesh.h"

#include <filesystem>
#include <iosfwd>
#include <string>

namespace soms {

/// Formats that can be written.
enum class MeshFormat { ply, ply_ascii, obj, stl, stl_ascii, off };

/// Format for a file name by its ending (.ply, .obj, .stl, .off; any case).
/// \errors  ErrorKind::unsupported naming the endings that are offered.
[[nodiscard]] MeshFormat format_for(const std::filesystem::path& path);

/// Writes a mesh; the file appears whole or not at all (written beside, then renamed). PLY, OBJ and
/// OFF are read back equal in vertices and triangles (doubles are kept); binary STL holds floats.
/// \errors  ErrorKind::cannot_write, out_of_range (a coordinate that a float cannot hold),
/// cancelled.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh, MeshFormat format,
                const Parallel& parallel = {});

/// The same to a stream; `name` is used in messages.
void write_mesh(std::ostream& out, const std::string& name, const Mesh& mesh, MeshFormat format,
                const Parallel& parallel = {});

}  // namespace soms
