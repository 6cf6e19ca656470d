#include "soms/io/detail/file.h"

#include "soms/base/error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

namespace soms::detail {

namespace {

constexpr std::uint64_t kMostOfPipe = std::uint64_t{1} << 32;

/// Closes a file when it goes.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}

  ~Descriptor() { close(fd_); }

  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what,
                       const std::string& remedy) {
  throw Error(ErrorKind::cannot_open, path.string() + ": " + what, remedy);
}

[[noreturn]] void fail_system(const std::filesystem::path& path, int code) {
  fail(path, std::generic_category().message(code),
       code == ENOENT   ? "check the name and the folder"
       : code == EACCES ? "ask for the right to read it"
                        : "check the file");
}

[[noreturn]] void fail_size(const std::filesystem::path& path, std::uint64_t most) {
  throw Error(ErrorKind::out_of_memory,
              path.string() + ": more than the " + std::to_string(most) + " bytes that may be used",
              "raise the limit (max_memory, --max-memory)");
}

/// Reads up to `wanted` bytes; fewer only at the end.
std::size_t read_up_to(const std::filesystem::path& path, int fd, char* to, std::size_t wanted) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 26;
  std::size_t done = 0;
  while (done < wanted) {
    const ssize_t got = read(fd, to + done, std::min(wanted - done, kAtOnce));
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      fail_system(path, errno);
    }
    if (got == 0) {
      break;
    }
    done += static_cast<std::size_t>(got);
  }
  return done;
}

/// A pipe has no size: the memory doubles until its end.
FileBytes read_pipe(const std::filesystem::path& path, int fd, std::uint64_t most) {
  FileBytes bytes;
  std::size_t capacity = 0;
  most = most > 0 ? most : kMostOfPipe;
  while (bytes.size == capacity) {
    if (capacity >= most) {
      fail_size(path, most);
    }
    capacity = std::min<std::uint64_t>(most, std::max<std::uint64_t>(1 << 16, 2 * capacity));
    auto larger = std::make_unique_for_overwrite<char[]>(capacity);
    if (bytes.size > 0) {
      std::memcpy(larger.get(), bytes.data.get(), bytes.size);
    }
    bytes.data = std::move(larger);
    bytes.size += read_up_to(path, fd, bytes.data.get() + bytes.size, capacity - bytes.size);
  }
  return bytes;
}

}  // namespace

FileBytes read_file(const std::filesystem::path& path, std::uint64_t most) {
  const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) {
    fail_system(path, errno);
  }
  const Descriptor file(fd);

  struct stat status {};

  if (fstat(file.get(), &status) != 0) {
    fail_system(path, errno);
  }
  if (S_ISDIR(status.st_mode)) {
    fail(path, "a folder, not a file", "name a file in it");
  }
  if (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode)) {
    return read_pipe(path, file.get(), most);
  }
  if (!S_ISREG(status.st_mode)) {
    fail(path, "a device, not a file", "name a file");
  }
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (most > 0 && size > most) {
    fail_size(path, most);
  }
  FileBytes bytes;
  bytes.data = std::make_unique_for_overwrite<char[]>(static_cast<std::size_t>(size));
  bytes.size = read_up_to(path, file.get(), bytes.data.get(), static_cast<std::size_t>(size));
  return bytes;
}

}  // namespace soms::detail
