#include "soms/io/detail/file.h"

#include "soms/base/error.h"
#include "soms/base/portable.h"
#include "soms/base/text.h"
#include "soms/io/detail/links.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

namespace soms::detail {

namespace {

constexpr std::uint64_t kMostOfPipe = std::uint64_t{1} << 32;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what,
                       const std::string& remedy) {
  throw Error(ErrorKind::cannot_open, path.string() + ": " + what, remedy);
}

[[noreturn]] void fail_system(const std::filesystem::path& path, int code) {
  fail(path, std::generic_category().message(code),
       code == ENOENT   ? "check the path"
       : code == EACCES ? "check its permissions"
                        : "check the file");
}

[[noreturn]] void fail_size(const std::filesystem::path& path, std::uint64_t most) {
  throw Error(ErrorKind::out_of_memory,
              path.string() + ": the file exceeds the memory limit of " + readable_bytes(most),
              "raise the limit (max_memory)");
}

/// Reads up to `wanted` bytes; fewer only at the end.
std::size_t read_up_to(const std::filesystem::path& path, int fd, char* to, std::size_t wanted,
                       const Limits& limits) {
  std::size_t done = 0;
  while (done < wanted) {
    check(limits);
    const std::size_t got = read_some(path, fd, to + done, wanted - done, limits);
    if (got == 0) {
      break;
    }
    done += got;
  }
  return done;
}

/// A pipe has no size: the memory doubles until its end.
FileBytes read_pipe(const std::filesystem::path& path, int fd, std::uint64_t most,
                    const Limits& limits) {
  FileBytes bytes;
  std::size_t capacity = 0;
  most = most > 0 ? most : kMostOfPipe;
  while (bytes.size == capacity) {
    if (capacity >= most) {
      fail_size(path, most);
    }
    capacity = std::min<std::uint64_t>(most, std::max<std::uint64_t>(1 << 16, 2 * capacity));
    auto larger = make_array_for_overwrite<char>(capacity);
    if (bytes.size > 0) {
      std::memcpy(larger.get(), bytes.data.get(), bytes.size);
    }
    bytes.data = std::move(larger);
    bytes.size +=
        read_up_to(path, fd, bytes.data.get() + bytes.size, capacity - bytes.size, limits);
  }
  return bytes;
}

int open_or_fail(const std::filesystem::path& path, int flags) {
  int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC | flags);
  if (fd < 0) {
    const int reason = errno;
    // No name reopens a socket, and some programs give one as standard input.
    const int named = reason == ENXIO ? named_descriptor(path) : -1;
    fd = named < 0 ? -1 : fcntl(named, F_DUPFD_CLOEXEC, 0);
    if (fd < 0) {
      fail_system(path, reason);
    }
  }
  return fd;
}

struct stat status_of(const std::filesystem::path& path, int fd) {
  struct stat status {};

  if (fstat(fd, &status) != 0) {
    fail_system(path, errno);
  }
  return status;
}

/// A regular file whole; `most` is the most bytes to read, 0 means any.
FileBytes read_regular(const std::filesystem::path& path, int fd, std::uint64_t most,
                       const Limits& limits) {
  const struct stat status = status_of(path, fd);
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (most > 0 && size > most) {
    fail_size(path, most);
  }
  FileBytes bytes;
  bytes.data = make_array_for_overwrite<char>(static_cast<std::size_t>(size));
  bytes.size = read_up_to(path, fd, bytes.data.get(), static_cast<std::size_t>(size), limits);
  // A read beside a truncation may see zeros.
  const struct stat after = status_of(path, fd);
  if (after.st_size != status.st_size || after.st_mtim.tv_sec != status.st_mtim.tv_sec ||
      after.st_mtim.tv_nsec != status.st_mtim.tv_nsec) {
    fail(path, "the file changed while it was being read",
         "read it again when nothing writes to it");
  }
  return bytes;
}

/// Waits for bytes or the end: a pipe into which nobody writes must not hold up a stop.
void wait_for_bytes(const std::filesystem::path& path, int fd, const Limits& limits) {
  constexpr int kMilliseconds = 50;
  const int most = limits.stop.stop_possible() ? kMilliseconds : -1;
  pollfd ready{fd, POLLIN, 0};
  for (int found = 0; found <= 0;) {
    found = poll(&ready, 1, most);
    if (found < 0 && errno != EINTR) {
      fail_system(path, errno);
    }
    if (found <= 0) {
      check(limits);
    }
  }
}

}  // namespace

Descriptor::~Descriptor() {
  close(fd_);
}

int open_for_reading(const std::filesystem::path& path) {
  // Else opening a pipe would wait for one who writes into it, without an eye on a stop.
  const int fd = open_or_fail(path, O_NONBLOCK);

  struct stat status {};

  const int code = fstat(fd, &status) == 0 ? 0 : errno;
  if (code != 0 || S_ISDIR(status.st_mode)) {
    close(fd);
    if (code != 0) {
      fail_system(path, code);
    }
    fail(path, "a folder, not a file", "name a file in it");
  }
  return fd;
}

std::size_t read_some(const std::filesystem::path& path, int fd, char* to, std::size_t wanted,
                      const Limits& limits) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 26;
  while (true) {
    wait_for_bytes(path, fd, limits);
    const ssize_t got = read(fd, to, std::min(wanted, kAtOnce));
    if (got >= 0) {
      return static_cast<std::size_t>(got);
    }
    // Another reader of the pipe may have been faster.
    if (errno != EINTR && errno != EAGAIN) {
      fail_system(path, errno);
    }
  }
}

bool is_readable(int fd) {
  pollfd ready{fd, POLLIN, 0};
  return poll(&ready, 1, 0) > 0;
}

FileBytes read_file(const std::filesystem::path& path, std::uint64_t most, const Limits& limits) {
  const Descriptor file(open_for_reading(path));
  const mode_t mode = status_of(path, file.get()).st_mode;
  if (S_ISFIFO(mode) || S_ISSOCK(mode)) {
    return read_pipe(path, file.get(), most, limits);
  }
  if (!S_ISREG(mode)) {
    fail(path, "a device, not a file", "name a file");
  }
  return read_regular(path, file.get(), most, limits);
}

RegularFile::RegularFile(std::filesystem::path path)
    : path_(std::move(path)), file_(open_or_fail(path_, O_NOFOLLOW | O_NONBLOCK)) {
  const struct stat status = status_of(path_, file_.get());
  if (!S_ISREG(status.st_mode)) {
    fail(path_, "not a regular file", "name a file");
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
  id_ = {status.st_dev, status.st_ino};
}

FileBytes RegularFile::read() const {
  return read_regular(path_, file_.get(), std::max<std::uint64_t>(1, size_), {});
}

}  // namespace soms::detail
