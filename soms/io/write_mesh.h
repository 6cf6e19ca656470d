/// \file
/// Writing models: PLY, 3DS, STL, OFF, OBJ, GLB.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/words.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>

namespace soms {

/// Formats that can be written.
enum class MeshFormat { ply, ply_ascii, obj, stl, stl_ascii, off, three_ds, glb };

template <>
inline constexpr auto kWords<MeshFormat> = words("MeshFormat",
                                                 "Formats that models are written in.", "ply",
                                                 "ply_ascii", "obj", "stl", "stl_ascii", "off",
                                                 "three_ds", "glb");

/// Format for a file name by its extension (.ply, .3ds, .stl, .off, .obj, .glb; any case).
/// \errors  ErrorKind::unsupported naming the extensions that are offered.
[[nodiscard]] MeshFormat format_for(const std::filesystem::path& path);

/// Writes a mesh; the file appears whole or not at all (written beside, then renamed; where the old
/// file has several names, the others keep it: see NewFile). PLY, OBJ and
/// OFF are read back equal in vertices and triangles (doubles are kept); binary STL, 3DS and GLB
/// hold floats. 3DS is read back with the same triangles in the same order, in objects of at most
/// 65,535 vertices and faces, whose names are cut to ten characters and made unique. GLB keeps
/// parts as nodes; the floats of a mesh far from the origin count from its middle. Axes are not
/// turned. \errors  What `check` says of the mesh; ErrorKind::cannot_write, not_finite,
/// out_of_range (a
///          coordinate that a float cannot hold, more than the 4 GiB that 3DS and GLB have room
///          for), cancelled.
void write_mesh(const std::filesystem::path& path, const MeshView& mesh, MeshFormat format,
                const Limits& limits = {});

/// The same to a stream; `name` is used in messages.
void write_mesh(std::ostream& out, const std::string& name, const MeshView& mesh, MeshFormat format,
                const Limits& limits = {});

/// What a format that holds floats does to a mesh.
struct Rounding {
  std::uint64_t count = 0;  ///< vertices that are not read back equal
  double most = 0;          ///< largest difference of a coordinate

  [[nodiscard]] bool operator==(const Rounding&) const = default;
};

/// Vertices that a format does not write are left out. \pre `check(mesh)` passes. \cost One pass.
[[nodiscard]] Rounding rounding(const MeshView& mesh, MeshFormat format);

/// Vertices that are not read back equal from this format, because it holds floats.
/// \cost One pass.
[[nodiscard]] std::uint64_t count_rounded(const MeshView& mesh, MeshFormat format);

/// Parts whose names this format changes: 3DS holds ten characters of ASCII, different for each
/// object, and OBJ holds groups of different names. \pre `check(mesh)` passes. \errors
/// ErrorKind::out_of_range as `write_mesh`. \cost One pass.
[[nodiscard]] std::uint64_t count_renamed(const MeshView& mesh, MeshFormat format);

}  // namespace soms
