#include "apps/output/output.h"

#include "soms/base/error.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

namespace soms::command {

namespace {

constexpr int kStandardOutput = 1;

/// True for the file behind standard output, by whatever name.
bool is_standard_output(int descriptor) {
  struct stat own {};

  struct stat standard {};

  return descriptor == kStandardOutput ||
         (::fstat(descriptor, &own) == 0 && ::fstat(kStandardOutput, &standard) == 0 &&
          own.st_dev == standard.st_dev && own.st_ino == standard.st_ino);
}

[[noreturn]] void throw_cannot_write(const std::string& name, int error) {
  const char* remedy = "choose another location for the output";
  if (error == ENOSPC || error == EDQUOT || error == EFBIG) {
    remedy = "free some space, or choose another location";
  }
  throw Error(ErrorKind::cannot_write,
              fmt::format("{}: cannot write: {}", name, std::generic_category().message(error)),
              remedy);
}

std::filesystem::path real_path(const std::string& path) {
  std::error_code failed;
  std::filesystem::path real = std::filesystem::absolute(path, failed);
  if (!failed) {
    real = std::filesystem::weakly_canonical(real, failed);
  }
  return failed ? std::filesystem::path(path) : real;
}

}  // namespace

FileStream::Buffer::Buffer(int descriptor) : descriptor_(descriptor) {
  setp(bytes_.data(), bytes_.data() + bytes_.size());
}

bool FileStream::Buffer::write_all(const char* text, std::size_t size) {
  while (size > 0 && error_ == 0) {
    const ssize_t written = ::write(descriptor_, text, size);
    if (written < 0 && errno != EINTR) {
      error_ = errno;
    } else if (written > 0) {
      text += written;
      size -= static_cast<std::size_t>(written);
    }
  }
  return error_ == 0;
}

int FileStream::Buffer::sync() {
  const bool good = write_all(pbase(), static_cast<std::size_t>(pptr() - pbase()));
  setp(bytes_.data(), bytes_.data() + bytes_.size());
  return good ? 0 : -1;
}

FileStream::Buffer::int_type FileStream::Buffer::overflow(int_type c) {
  if (sync() != 0) {
    return traits_type::eof();
  }
  if (!traits_type::eq_int_type(c, traits_type::eof())) {
    *pptr() = traits_type::to_char_type(c);
    pbump(1);
  }
  return traits_type::not_eof(c);
}

std::streamsize FileStream::Buffer::xsputn(const char* text, std::streamsize size) {
  if (size > epptr() - pptr() && sync() != 0) {
    return 0;
  }
  if (size > epptr() - pptr()) {
    return write_all(text, static_cast<std::size_t>(size)) ? size : 0;
  }
  std::copy_n(text, size, pptr());
  pbump(static_cast<int>(size));
  return size;
}

FileStream::FileStream(int descriptor, std::string name)
    : std::ostream(nullptr), buffer_(descriptor), name_(std::move(name)) {
  rdbuf(&buffer_);
}

void FileStream::finish() {
  flush();
  if (buffer_.error() == EPIPE && is_standard_output(buffer_.descriptor())) {
    throw ClosedPipe();
  }
  if (buffer_.error() != 0) {
    throw_cannot_write(name_, buffer_.error());
  }
  if (!good()) {
    throw Error(ErrorKind::cannot_write, name_ + ": cannot write",
                "choose another location for the output");
  }
}

OutputFile::OutputFile(const std::filesystem::path& path)
    : name_(path == "-" ? "standard output" : path.string()) {
  int descriptor = kStandardOutput;
  if (path != "-") {
    if (const int error = file_.open(path); error != 0) {
      throw_cannot_write(name_, error);
    }
    descriptor = file_.descriptor();
  }
  stream_ = std::make_unique<FileStream>(descriptor, name_);
}

void OutputFile::sync() {
  stream_->finish();
  if (::fsync(file_.descriptor()) != 0) {
    throw_cannot_write(name_, errno);
  }
}

void OutputFile::commit() {
  stream_->finish();
  if (file_.descriptor() < 0) {
    return;
  }
  if (const int error = file_.commit(); error != 0) {
    throw_cannot_write(name_, error);
  }
}

void make_durable(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  int error = descriptor < 0 ? errno : 0;
  // Some file systems have no such thing for folders, and say EINVAL.
  if (descriptor >= 0 && ::fsync(descriptor) != 0 && errno != EINVAL) {
    error = errno;
  }
  if (descriptor >= 0) {
    ::close(descriptor);
  }
  if (error != 0) {
    throw_cannot_write(path.string(), error);
  }
}

void check_outputs(NamedFiles taken, const NamedFiles& outputs) {
  for (const auto& output : outputs) {
    const auto& [name, path] = output;
    if (path.empty() || path == "/dev/null") {
      continue;
    }
    if (path == "-" || path == "/dev/stdout") {
      throw Error(
          ErrorKind::usage,
          fmt::format("{} {}: the answer is already written to standard output", name, path),
          "give the name of a file");
    }
    for (const auto& [other, other_path] : taken) {
      if (other_path != "-" && !other_path.empty() && real_path(path) == real_path(other_path)) {
        throw Error(ErrorKind::usage,
                    fmt::format("{} {}: {} names the same file", name, path, other),
                    "give another file");
      }
    }
    taken.push_back(output);
  }
}

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void check_extension(const std::string& option, const std::filesystem::path& path,
                     const std::vector<std::string_view>& extensions) {
  const std::string extension = extension_of(path);
  std::error_code unknown;
  const std::filesystem::file_status there = std::filesystem::status(path, unknown);
  const bool device = std::filesystem::exists(there) && !std::filesystem::is_regular_file(there);
  if (extension.empty() || device ||
      std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) {
    return;
  }
  throw Error(
      ErrorKind::usage, fmt::format("{} {}", option, path.string()),
      fmt::format("use {} {}", extensions.size() == 1 ? "the extension" : "one of the extensions",
                  fmt::join(extensions, ", ")));
}

void print_error(std::string_view who, std::string_view message) {
  const bool color = wants_color(2);
  const std::string line = fmt::format("{}{}:{} {}\n", color ? "\x1b[1;31m" : "", who,
                                       color ? "\x1b[0m" : "", printable(message));
  (void)!::write(2, line.data(), line.size());
}

bool wants_color(int descriptor) {
  const auto value = [](const char* name) {
    const char* const text = std::getenv(name);
    return std::string_view(text == nullptr ? "" : text);
  };
  if (!value("NO_COLOR").empty()) {
    return false;
  }
  if (const std::string_view forced = value("CLICOLOR_FORCE"); !forced.empty() && forced != "0") {
    return true;
  }
  const std::string_view kind = value("TERM");
  return ::isatty(descriptor) == 1 && value("CLICOLOR") != "0" && !kind.empty() && kind != "dumb";
}

}  // namespace soms::command
