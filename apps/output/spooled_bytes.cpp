#include "apps/output/spooled_bytes.h"

#include "soms/base/error.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

namespace soms::command {

namespace {

[[noreturn]] void throw_cannot_spool(const char* doing, int error) {
  throw Error(ErrorKind::cannot_write,
              fmt::format("a temporary file of answers: cannot {}: {}", doing,
                          std::generic_category().message(error)),
              "set TMPDIR to another folder, or free some space");
}

/// A file without a name, which goes with its descriptor.
int open_spool() {
  std::error_code unknown;
  const std::filesystem::path base = std::filesystem::temp_directory_path(unknown);
  std::string pattern = ((unknown ? std::filesystem::path("/tmp") : base) / "soms-XXXXXX").string();
  const int file = ::mkostemp(pattern.data(), O_CLOEXEC);
  if (file < 0) {
    throw_cannot_spool("create it", errno);
  }
  ::unlink(pattern.c_str());
  return file;
}

}  // namespace

SpooledBytes::~SpooledBytes() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

void SpooledBytes::spool() {
  if (file_ < 0) {
    file_ = open_spool();
  }
  for (std::size_t at = 0; at < bytes_.size();) {
    const ssize_t written = ::write(file_, bytes_.data() + at, bytes_.size() - at);
    if (written < 0 && errno != EINTR) {
      throw_cannot_spool("write", errno);
    }
    at += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
  }
  spooled_ += bytes_.size();
  bytes_.clear();
}

void SpooledBytes::read(const std::function<void(std::string_view)>& take) const {
  std::vector<char> piece(spooled_ == 0 ? 0 : kInMemory);
  for (std::uint64_t at = 0; at < spooled_;) {
    const ssize_t got = ::pread(file_, piece.data(), piece.size(), static_cast<off_t>(at));
    if (got == 0 || (got < 0 && errno != EINTR)) {
      throw_cannot_spool("read it back", got == 0 ? EIO : errno);
    }
    if (got > 0) {
      take({piece.data(), static_cast<std::size_t>(got)});
      at += static_cast<std::uint64_t>(got);
    }
  }
  take(bytes_);
}

}  // namespace soms::command
