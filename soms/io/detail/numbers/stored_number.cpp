#include "soms/io/detail/numbers/stored_number.h"

#include "soms/base/portable.h"
#include "soms/base/text.h"

#include <algorithm>
#include <array>

namespace soms::detail {

namespace {

struct NamedType {
  std::string_view name;
  StoredType type;
};

constexpr std::array<NamedType, 18> kTypesByName = {{
    {"BYTE", {StoredKind::with_sign, 1}},
    {"UNSIGNED_BYTE", {StoredKind::whole, 1}},
    {"SHORT", {StoredKind::with_sign, 2}},
    {"UNSIGNED_SHORT", {StoredKind::whole, 2}},
    {"INT", {StoredKind::with_sign, 4}},
    {"UNSIGNED_INT", {StoredKind::whole, 4}},
    {"FLOAT", {StoredKind::real, 4}},
    {"DOUBLE", {StoredKind::real, 8}},
    {"INT8", {StoredKind::with_sign, 1}},
    {"UINT8", {StoredKind::whole, 1}},
    {"INT16", {StoredKind::with_sign, 2}},
    {"UINT16", {StoredKind::whole, 2}},
    {"INT32", {StoredKind::with_sign, 4}},
    {"UINT32", {StoredKind::whole, 4}},
    {"INT64", {StoredKind::with_sign, 8}},
    {"UINT64", {StoredKind::whole, 8}},
    {"FLOAT32", {StoredKind::real, 4}},
    {"FLOAT64", {StoredKind::real, 8}},
}};

/// The number of `type`, which holds its sign in the highest bit.
std::int64_t with_sign(std::uint64_t bits, std::size_t size) {
  const std::size_t unused = 64 - 8 * size;
  // A shift of what has a sign repeats it.
  return static_cast<std::int64_t>(bits << unused) >> unused;
}

double real(std::uint64_t bits, std::size_t size) {
  if (size == sizeof(double)) {
    return bit_cast<double>(bits);
  }
  const auto value = bit_cast<float>(static_cast<std::uint32_t>(bits));
  return value;
}

}  // namespace

std::optional<StoredType> stored_type(std::string_view name) {
  const auto* const found =
      std::find_if(kTypesByName.begin(), kTypesByName.end(),
                   [&](const NamedType& named) { return named.name == name; });
  return found == kTypesByName.end() ? std::nullopt : std::optional(found->type);
}

std::uint64_t stored_whole(std::string_view bytes, std::size_t at, StoredType type) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < type.size; ++i) {
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  }
  return bits;
}

double stored_number(std::string_view bytes, std::size_t at, StoredType type) {
  const std::uint64_t bits = stored_whole(bytes, at, type);
  switch (type.kind) {
    case StoredKind::whole:
      return static_cast<double>(bits);
    case StoredKind::with_sign:
      return static_cast<double>(with_sign(bits, type.size));
    case StoredKind::real:
      return real(bits, type.size);
  }
  return 0;
}

std::string stored_text(std::string_view bytes, std::size_t at, StoredType type) {
  const std::uint64_t bits = stored_whole(bytes, at, type);
  switch (type.kind) {
    case StoredKind::whole:
      return std::to_string(bits);
    case StoredKind::with_sign:
      return std::to_string(with_sign(bits, type.size));
    case StoredKind::real:
      return shortest(real(bits, type.size));
  }
  return {};
}

}  // namespace soms::detail
