/// \file
/// The bytes of a tree file (`.somst`): a shape as queries use it, opened without being read or
/// built again. `soms/store/tree_file.h` has the same by the path of a file.
///
/// A file is a head of 4,096 bytes and sections, each of which begins at a multiple of 4,096.
/// Sections are arrays of fixed records, least byte first, with every unused byte 0. So the bytes
/// of a shape are the same on every machine, and each array is used where it lies.
/// docs/tree_file.md has the format.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/words.h"
#include "soms/tree/shape.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace soms {

/// How closely a tree file is looked at before it is used.
enum class TreeCheck {
  /// The head alone. For files of your own making: a damaged one may crash the program.
  trusted,
  /// No index leads out of its array or in a circle, and all numbers are finite: whatever the file
  /// holds, queries end and touch no other memory. Their answers may be wrong.
  safe,
  /// Also the hash of every section, each triangle in one leaf, and the least triangle below each
  /// node: damage and interrupted copies are found. A forged file may still hold a box too small.
  sound,
  /// Also every box: the layout is made again over the mesh, and must have the same bytes. Then
  /// answers are exact, whoever wrote the file.
  full,
};

template <>
inline constexpr auto kWords<TreeCheck> =
    words("TreeCheck", "How closely a tree file is looked at before it is used.", "trusted", "safe",
          "sound", "full");

/// How a tree file is opened.
struct OpenOptions {
  TreeCheck check = TreeCheck::sound;
  /// Copy the file into memory of the program's own, on large pages, instead of mapping it.
  /// Processes do not share it then, and the file may change. Bytes are always copied.
  bool load = false;

  [[nodiscard]] bool operator==(const OpenOptions&) const = default;
};

/// First bytes of a tree file.
inline constexpr std::string_view kTreeFileMagic{"\x89SOMT\r\n\x1a", 8};

/// True if the bytes begin as a tree file does, of whichever version.
[[nodiscard]] bool is_tree_file(std::span<const std::byte> bytes);

/// Writes the bytes of a shape's tree file, in order, by calls of `put`. A canonical tree that was
/// kept is not in it.
/// \errors  What `put` throws; ErrorKind::unsupported on a machine whose most significant byte
///          comes first.
/// \cost    O(n): about 110 bytes a triangle, 41 with Layout::compact.
void write_tree_file(const Shape& shape,
                     const std::function<void(std::span<const std::byte>)>& put);

/// A shape from the bytes of a tree file, which are copied. Queries answer as those of the shape
/// that was saved. `name` stands for the file in messages.
/// \errors  ErrorKind::bad_file (names the section and the index), unsupported (another version),
///          cancelled.
/// \cost    O(n); docs/scale.md has figures of each check.
[[nodiscard]] Shape open_shape(std::span<const std::byte> bytes, const std::string& name,
                               const OpenOptions& options = {}, const Limits& limits = {});

/// The same without a copy: the shape and its copies keep `owner`, and the bytes must not change as
/// long as it lives. They must begin at a multiple of 64.
[[nodiscard]] Shape open_shape(std::shared_ptr<const void> owner, std::span<const std::byte> bytes,
                               const std::string& name, const OpenOptions& options = {},
                               const Limits& limits = {});

/// A number that stands for the content of a tree file: it is in the head, and covers all sections.
/// \errors  ErrorKind::bad_file.
[[nodiscard]] std::uint64_t tree_file_hash(std::span<const std::byte> bytes,
                                           const std::string& name);

}  // namespace soms
