#include "soms/tiles/detail/tile_ids.h"

#include "soms/base/error.h"
#include "soms/base/lanes_hash.h"

#include <fmt/format.h>

#include <cstring>
#include <string_view>

namespace soms::detail {

namespace {

constexpr std::size_t kHeaderBytes = 128;

[[noreturn]] void fail(const std::string& name, const std::string& what) {
  throw Error(ErrorKind::bad_file, name + ": " + what, "cut the models again: soms tile");
}

/// \source NumPy Enhancement Proposal 1, A simple file format for NumPy arrays.
std::string header(std::uint64_t count) {
  std::string text = "\x93NUMPY";
  text += {'\x01', '\0', static_cast<char>(kHeaderBytes - 10), '\0'};
  text += fmt::format("{{'descr': '<u8', 'fortran_order': False, 'shape': ({},), }}", count);
  text.resize(kHeaderBytes - 1, ' ');
  return text + '\n';
}

}  // namespace

std::string tile_ids_bytes(std::span<const std::uint64_t> ids) {
  std::string bytes = header(ids.size());
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): tree files are written by machines
  // of this byte order alone
  bytes.append(reinterpret_cast<const char*>(ids.data()), ids.size_bytes());
  return bytes;
}

std::uint64_t tile_ids_hash(std::span<const std::uint64_t> ids) {
  return lanes_hash(std::as_bytes(ids));
}

std::span<const std::uint64_t> tile_ids_of(const HeldBytes& held, std::uint64_t count,
                                           const std::string& name) {
  const std::span<const std::byte> bytes = held.bytes;
  const std::string expected = header(count);
  if (bytes.size() < kHeaderBytes ||
      (bytes.size() - kHeaderBytes) / sizeof(std::uint64_t) != count ||
      bytes.size() % sizeof(std::uint64_t) != 0 ||
      std::memcmp(bytes.data(), expected.data(), kHeaderBytes) != 0) {
    fail(name, fmt::format("no array of {} whole numbers", count));
  }
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): that is what the file holds
  return {reinterpret_cast<const std::uint64_t*>(bytes.data() + kHeaderBytes),
          static_cast<std::size_t>(count)};
}

void check_tile_ids(std::span<const std::uint64_t> ids, std::uint64_t begin, std::uint64_t end,
                    const std::string& name) {
  std::uint64_t least = begin;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (ids[k] < least || ids[k] >= end) {
      fail(name, fmt::format("number {} is {}, which does not ascend or is none of its source", k,
                             ids[k]));
    }
    least = ids[k] + 1;
  }
}

}  // namespace soms::detail
