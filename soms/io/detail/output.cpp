#include "soms/io/detail/output.h"

#include "soms/base/error.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace soms::detail {

Output::Output(std::function<void(std::string_view)> write)
    : write_(std::move(write)), buffer_(kCapacity) {
}

void Output::put(std::string_view text) {
  while (!text.empty()) {
    make_room(1);
    const std::size_t part = std::min(text.size(), buffer_.size() - size_);
    std::copy_n(text.data(), part, buffer_.data() + size_);
    size_ += part;
    text.remove_prefix(part);
  }
}

void Output::put_bits(std::uint64_t bits, std::size_t bytes) {
  make_room(bytes);
  for (std::size_t i = 0; i < bytes; ++i) {
    buffer_[size_++] = static_cast<char>(bits >> (8 * i) & 0xff);
  }
}

void Output::flush() {
  write_({buffer_.data(), size_});
  size_ = 0;
}

OutputFile::OutputFile(const std::filesystem::path& path) : path_(path), target_(path) {
  struct stat status {};

  const bool exists = stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    fail(EISDIR);
  }
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) {
      fail(errno);
    }
    return;
  }
  if (exists && access(path.c_str(), W_OK) != 0) {
    fail(errno);
  }
  std::error_code error;
  if (std::filesystem::is_symlink(path, error)) {
    target_ = std::filesystem::weakly_canonical(path, error);
    if (error) {
      fail(error.value());
    }
  }
  open_beside();
  if (exists && fchmod(descriptor_, status.st_mode & 07777) != 0) {
    const int code = errno;
    close(descriptor_);
    unlink(temporary_.c_str());
    fail(code);
  }
}

/// Opens a new file in the target's folder, named so that no other writer of this or another
/// process takes it.
void OutputFile::open_beside() {
  constexpr int kMostTries = 10000;
  for (int i = 0; i < kMostTries; ++i) {
    temporary_ = target_;
    temporary_ += fmt::format(".{}-{}.tmp", getpid(), i);
    descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) {
      return;
    }
    if (errno != EEXIST) {
      break;
    }
  }
  fail(errno);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) {
    close(descriptor_);
    if (!temporary_.empty()) {
      unlink(temporary_.c_str());
    }
  }
}

void OutputFile::fail(int code) const {
  throw Error(ErrorKind::cannot_write,
              path_.string() + ": " + std::generic_category().message(code),
              code == ENOSPC ? "free some space, or write elsewhere"
                             : "check the folder and the right to write there");
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      fail(errno);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::commit() {
  const int descriptor = std::exchange(descriptor_, -1);
  const int code = close(descriptor) == 0 ? 0 : errno;
  if (temporary_.empty()) {
    if (code != 0) {
      fail(code);
    }
    return;
  }
  if (code != 0 || rename(temporary_.c_str(), target_.c_str()) != 0) {
    const int reason = code != 0 ? code : errno;
    unlink(temporary_.c_str());
    fail(reason);
  }
}

}  // namespace soms::detail
