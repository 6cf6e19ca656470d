/// \file
/// Writing: to a descriptor with errors that say why, and to files that appear whole or not at all.
#pragma once

#include "soms/base/text.h"
#include "soms/io/new_file.h"

#include <array>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

/// Thrown when the reader of standard output went away: the program ends quietly.
struct ClosedPipe : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "closed pipe"; }
};

/// An output stream over a descriptor that remembers why a write failed.
class FileStream : public std::ostream {
 public:
  /// `name` is used in messages. The descriptor is not closed.
  FileStream(int descriptor, std::string name);

  /// Writes out what is held back.
  /// \errors ErrorKind::cannot_write, now or of any write before; ClosedPipe.
  void finish();

 private:
  class Buffer : public std::streambuf {
   public:
    explicit Buffer(int descriptor);

    [[nodiscard]] int descriptor() const { return descriptor_; }

    [[nodiscard]] int error() const { return error_; }

   protected:
    int_type overflow(int_type c) override;
    std::streamsize xsputn(const char* text, std::streamsize size) override;
    int sync() override;

   private:
    bool write_all(const char* text, std::size_t size);

    int descriptor_;
    int error_ = 0;
    std::array<char, 1 << 16> bytes_{};
  };

  Buffer buffer_;
  std::string name_;
};

/// An output file that appears whole or not at all, as NewFile does. "-" is standard output.
class OutputFile {
 public:
  /// \errors ErrorKind::cannot_write.
  explicit OutputFile(const std::filesystem::path& path);

  [[nodiscard]] std::ostream& stream() { return *stream_; }

  /// Path as given, or "standard output".
  [[nodiscard]] const std::string& name() const { return name_; }

  /// As NewFile says: other names (hard links) of the file that is replaced.
  [[nodiscard]] std::uint64_t other_names() const { return file_.other_names(); }

  /// Throws if something could not be written so far. \errors As `commit`.
  void check() { stream_->finish(); }

  /// Has the system put what is written so far where a loss of power leaves it. \errors As
  /// `commit`.
  void sync();

  /// Makes the file appear. \errors ErrorKind::cannot_write; ClosedPipe.
  void commit();

 private:
  std::string name_;
  NewFile file_;
  std::unique_ptr<FileStream> stream_;
};

/// Has the system put a file, or the names in a folder, where a loss of power leaves them.
/// \errors ErrorKind::cannot_write.
void make_durable(const std::filesystem::path& path);

/// Options, or their meanings, with the files that they name.
using NamedFiles = std::vector<std::pair<std::string, std::string>>;

/// Throws if one of `outputs` is standard output, which holds the answers, or overwrites a file
/// that is read (`taken`) or another output. Empty names and /dev/null are passed over. \errors
/// ErrorKind::usage.
void check_outputs(NamedFiles taken, const NamedFiles& outputs);

/// The extension of a file's name, in lower case: ".csv".
[[nodiscard]] std::string extension_of(const std::filesystem::path& path);

/// Throws if a file named by `option` has another extension than those of what is written, the
/// first of which the message names (".svg"). Empty names, names without a file extension, and what
/// exists and is no regular file, such as a device, are passed over. \errors ErrorKind::usage.
void check_extension(const std::string& option, const std::filesystem::path& path,
                     const std::vector<std::string_view>& extensions);

/// Prints "WHO: MESSAGE" to standard error, in color on a terminal.
void print_error(std::string_view who, std::string_view message);

/// True if a descriptor is a terminal that understands colors, unless CLICOLOR is 0; of anything
/// else if CLICOLOR_FORCE is set. Never with NO_COLOR.
[[nodiscard]] bool wants_color(int descriptor);

}  // namespace soms::command
