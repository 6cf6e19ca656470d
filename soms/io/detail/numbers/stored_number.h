/// \file
/// Numbers of tables in files, of all the types that 3D Tiles and glTF store them in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace soms::detail {

enum class StoredKind : std::uint8_t { whole, with_sign, real };

/// Type of a stored number, little-endian.
struct StoredType {
  StoredKind kind = StoredKind::real;
  std::size_t size = 0;  ///< bytes: 1, 2, 4 or 8; of reals 4 or 8

  [[nodiscard]] bool operator==(const StoredType&) const = default;
};

/// The type of that name in 3D Tiles ("UNSIGNED_BYTE") or in glTF's metadata ("UINT8").
[[nodiscard]] std::optional<StoredType> stored_type(std::string_view name);

/// The number at byte `at`. \pre All its bytes exist.
[[nodiscard]] double stored_number(std::string_view bytes, std::size_t at, StoredType type);

/// The number as text: whole ones exactly, others in the shortest form that is read back equal.
/// \pre As above.
[[nodiscard]] std::string stored_text(std::string_view bytes, std::size_t at, StoredType type);

/// The whole number without sign at byte `at`. \pre As above, and the kind is `whole`.
[[nodiscard]] std::uint64_t stored_whole(std::string_view bytes, std::size_t at, StoredType type);

}  // namespace soms::detail
