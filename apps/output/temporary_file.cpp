#include "apps/output/temporary_file.h"

#include "soms/base/error.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

namespace soms::command {

TemporaryFile::TemporaryFile(std::string what) : what_(std::move(what)) {
  std::error_code unknown;
  const std::filesystem::path base = std::filesystem::temp_directory_path(unknown);
  std::string pattern = ((unknown ? std::filesystem::path("/tmp") : base) / "soms-XXXXXX").string();
  descriptor_ = ::mkostemp(pattern.data(), O_CLOEXEC);
  if (descriptor_ < 0) {
    refuse("create it", errno);
  }
  ::unlink(pattern.c_str());
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : what_(std::move(other.what_)), descriptor_(std::exchange(other.descriptor_, -1)) {
}

TemporaryFile& TemporaryFile::operator=(TemporaryFile&& other) noexcept {
  std::swap(what_, other.what_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

void TemporaryFile::add(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      refuse("write", errno);
    }
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
}

std::string TemporaryFile::path() const {
  return fmt::format("/proc/self/fd/{}", descriptor_);
}

void TemporaryFile::refuse(const char* doing, int error) const {
  throw Error(ErrorKind::cannot_write,
              fmt::format("a temporary file of {}: cannot {}: {}", what_, doing,
                          std::generic_category().message(error)),
              "set TMPDIR to another folder, or free some space");
}

}  // namespace soms::command
