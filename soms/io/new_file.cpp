#include "soms/io/new_file.h"

#include "soms/io/detail/links.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace soms {

namespace {

using detail::folder_of;
using detail::kMostLinks;

/// Tries names in the target's folder until `make` is not refused because a name is taken.
template <class Make>
int with_name_beside(const std::filesystem::path& target, std::filesystem::path& name,
                     const Make& make) {
  constexpr int kMostTries = 10000;
  for (int i = 0; i < kMostTries; ++i) {
    name = folder_of(target) / fmt::format(".soms-{}-{}.part", getpid(), i);
    if (make(name) >= 0) {
      return 0;
    }
    if (errno != EEXIST) {
      break;
    }
  }
  const int code = errno;
  name.clear();
  return code;
}

/// The file that is meant by `path`, whose last name may be a link, to another link or, where no
/// file exists, to nothing.
int follow_links(const std::filesystem::path& path, bool exists, std::filesystem::path& target) {
  target = path;
  std::error_code failed;
  if (exists && std::filesystem::is_symlink(path, failed)) {
    target = std::filesystem::canonical(path, failed);
    return failed.value();
  }
  for (int i = 0; std::filesystem::is_symlink(target, failed); ++i) {
    if (i == kMostLinks) {
      return ELOOP;
    }
    const std::filesystem::path next = std::filesystem::read_symlink(target, failed);
    if (failed) {
      return failed.value();
    }
    target = folder_of(target) / next;  // an absolute one stands alone
  }
  return target.filename().empty() ? EISDIR : 0;
}

}  // namespace

int NewFile::open(const std::filesystem::path& path) {
  struct stat status {};

  if (path.filename().empty()) {
    return EISDIR;
  }
  // Whoever opened it reads or writes on there: another file of its name would not be seen.
  if (const int named = detail::named_descriptor(path); named >= 0) {
    descriptor_ = fcntl(named, F_DUPFD_CLOEXEC, 0);
    return descriptor_ < 0 ? errno : 0;
  }
  const bool exists = stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    return EISDIR;
  }
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    return descriptor_ < 0 ? errno : 0;
  }
  if (exists && access(path.c_str(), W_OK) != 0) {
    return errno;
  }
  if (const int code = follow_links(path, exists, target_); code != 0) {
    return code;
  }
  if (open_nameless() != 0) {
    if (const int code = open_beside(); code != 0) {
      return code;
    }
  }
  if (exists) {
    (void)!fchmod(descriptor_, status.st_mode & 07777);
    // Some file systems count no links.
    other_names_ = status.st_nlink > 0 ? status.st_nlink - 1 : 0;
  }
  return 0;
}

/// Fails where the file system or the kernel has no such files, and where no name could be given.
int NewFile::open_nameless() {
  if (access("/proc/self/fd", X_OK) != 0) {
    return errno;
  }
  descriptor_ = ::open(folder_of(target_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  return descriptor_ < 0 ? errno : 0;
}

int NewFile::open_beside() {
  return with_name_beside(target_, beside_, [&](const std::filesystem::path& name) {
    return descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  });
}

/// Its own name where none has it; else another first, as only a rename takes the place of an old
/// file.
int NewFile::give_name() {
  const std::string open_file = fmt::format("/proc/self/fd/{}", descriptor_);
  if (linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, target_.c_str(), AT_SYMLINK_FOLLOW) == 0) {
    return 0;
  }
  return with_name_beside(target_, beside_, [&](const std::filesystem::path& name) {
    return linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW);
  });
}

int NewFile::commit() {
  const bool straight = target_.empty();
  const int named = straight || !beside_.empty() ? 0 : give_name();
  if (close(std::exchange(descriptor_, -1)) != 0) {
    return errno;
  }
  if (named != 0 || beside_.empty()) {
    return named;
  }
  if (rename(beside_.c_str(), target_.c_str()) != 0) {
    return errno;
  }
  beside_.clear();
  return 0;
}

NewFile::~NewFile() {
  if (descriptor_ >= 0) {
    close(descriptor_);
  }
  if (!beside_.empty()) {
    unlink(beside_.c_str());
  }
}

}  // namespace soms
