/// \file
/// The header of a PLY file: which elements follow, and how their properties are stored.
#pragma once

#include "soms/io/detail/source.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace soms::detail {

/// Types of properties, by their size and kind.
enum class PlyType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  float32,
  float64,
};

/// Bytes of a binary value.
[[nodiscard]] std::size_t size_of(PlyType type);

[[nodiscard]] constexpr bool is_floating(PlyType type) {
  return type == PlyType::float32 || type == PlyType::float64;
}

struct PlyProperty {
  std::string_view name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list
};

struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Position of the only property of this name. \errors ErrorKind::bad_file if it stands twice.
  [[nodiscard]] std::optional<std::size_t> find(const Source& source,
                                                std::string_view wanted) const;

  /// Fewest bytes of a binary row: lists may be empty. The size of every row if there are no lists.
  [[nodiscard]] std::uint64_t least_row() const;

  [[nodiscard]] bool has_lists() const;
};

enum class PlyFormat { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t body = 0;  ///< first byte behind the header
};

/// \errors ErrorKind::bad_file naming the line.
[[nodiscard]] PlyHeader read_ply_header(const Source& source);

}  // namespace soms::detail
