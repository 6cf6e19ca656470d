#include "soms/store/tree_file.h"

#include "soms/base/error.h"
#include "soms/io/detail/output.h"
#include "soms/store/detail/mapped_file.h"

#include <string_view>
#include <system_error>
#include <utility>

namespace soms {

void save(const std::filesystem::path& path, const Shape& shape) {
  detail::OutputFile file(path);
  write_tree_file(shape, [&](std::span<const std::byte> bytes) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are bytes
    file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  });
  file.commit();
}

Shape open_shape(const std::filesystem::path& path, const OpenOptions& options,
                 const Limits& limits) {
  detail::HeldBytes held = options.load ? detail::load_file(path) : detail::map_file(path);
  return open_shape(std::move(held.owner), held.bytes, path.string(), options, limits);
}

std::uint64_t tree_file_hash(const std::filesystem::path& path) {
  const detail::HeldBytes held = detail::map_file(path);
  return tree_file_hash(held.bytes, path.string());
}

bool is_tree_file(const std::filesystem::path& path) {
  std::error_code unknown;
  // A pipe would lose its first bytes.
  if (!std::filesystem::is_regular_file(path, unknown)) {
    return false;
  }
  try {
    const std::string_view magic = kTreeFileMagic;
    return is_tree_file(detail::first_bytes(path, magic.size()).bytes);
  } catch (const Error&) {
    return false;
  }
}

}  // namespace soms
