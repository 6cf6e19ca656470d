#include "soms/io/detail/links.h"

#include <charconv>
#include <string>
#include <system_error>

namespace soms::detail {

std::filesystem::path folder_of(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.parent_path();
  return folder.empty() ? "." : folder;
}

int named_descriptor(std::filesystem::path path) {
  std::error_code failed;
  const std::filesystem::path own = std::filesystem::canonical("/proc/self/fd", failed);
  for (int i = 0; i < kMostLinks && !failed; ++i) {
    std::error_code missing;
    if (std::filesystem::canonical(folder_of(path), missing) == own) {
      const std::string name = path.filename().string();
      int number = -1;
      const auto [end, fault] = std::from_chars(name.data(), name.data() + name.size(), number);
      return fault == std::errc() && end == name.data() + name.size() ? number : -1;
    }
    if (!std::filesystem::is_symlink(path, missing)) {
      return -1;
    }
    path = folder_of(path) / std::filesystem::read_symlink(path, failed);
  }
  return -1;
}

}  // namespace soms::detail
