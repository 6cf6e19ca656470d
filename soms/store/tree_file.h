/// \file
/// Tree files (`.somst`): a shape that is saved once, and opened without being read or built again.
///
/// \code
/// const soms::Shape city(soms::generate_city({.triangles = 20'000}).mesh);
/// soms::save("city.somst", city);
/// const soms::Shape opened = soms::open_shape("city.somst");
/// std::cout << opened.mesh().triangles.size() << " triangles; the same shape: " << std::boolalpha
///           << (opened == city) << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// 20000 triangles; the same shape: true
/// \endverbatim
#pragma once

#include "soms/base/limits.h"
#include "soms/tree/file/shape_bytes.h"
#include "soms/tree/shape.h"

#include <cstdint>
#include <filesystem>

namespace soms {

/// Writes a shape's tree file, which appears whole or not at all. A canonical tree that was kept is
/// not in it.
/// \errors  ErrorKind::cannot_write.
/// \cost    O(n): about 110 bytes a triangle, 41 with Layout::compact.
void save(const std::filesystem::path& path, const Shape& shape);

/// Opens a tree file. By default it is mapped: processes that open one file share its memory, and
/// what no query meets is never read. While a shape lives, its file may be removed or replaced by a
/// rename, as `save` does; a file that is written over in place makes answers undefined.
///
/// Queries answer as those of the shape that was saved, bit for bit and at the same cost.
///
/// \errors  ErrorKind::cannot_open; bad_file (names the section and the record); unsupported for
///          another version of the format: build the file again; cancelled.
/// \cost    By `options.check`: none but the mesh's statements, or O(n); docs/scale.md has figures.
[[nodiscard]] Shape open_shape(const std::filesystem::path& path, const OpenOptions& options = {},
                               const Limits& limits = {});

/// The hash of a tree file's content, from its head alone: two files with the same answer alike.
/// \errors  As `open_shape`.
[[nodiscard]] std::uint64_t tree_file_hash(const std::filesystem::path& path);

/// True if the file begins as a tree file does. False for what cannot be read.
[[nodiscard]] bool is_tree_file(const std::filesystem::path& path);

}  // namespace soms
