#include "soms/io/detail/output.h"

#include "soms/base/error.h"

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

OutputFile::OutputFile(const std::filesystem::path& path) : path_(path) {
  check(file_.open(path));
}

void OutputFile::check(int code) const {
  if (code != 0) {
    throw Error(ErrorKind::cannot_write,
                path_.string() + ": " + std::generic_category().message(code),
                code == ENOSPC ? "free some space, or choose another location"
                               : "check that the folder exists and is writable");
  }
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_.descriptor(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    check(written < 0 ? errno : 0);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::commit() {
  check(file_.commit());
}

}  // namespace soms::detail
