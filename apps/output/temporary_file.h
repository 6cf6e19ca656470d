/// \file
/// A file without a name, for what a program keeps for itself.
#pragma once

#include <string>
#include <string_view>

namespace soms::command {

/// Lies in the folder for temporary files (TMPDIR) and goes with its descriptor.
class TemporaryFile {
 public:
  /// `what` it is of, for messages: "answers". \errors ErrorKind::cannot_write.
  explicit TemporaryFile(std::string what);
  ~TemporaryFile();
  TemporaryFile(TemporaryFile&& other) noexcept;
  TemporaryFile& operator=(TemporaryFile&& other) noexcept;

  /// Adds bytes. \errors ErrorKind::cannot_write.
  void add(std::string_view bytes);

  /// What it can be opened by, from its beginning, while it is there.
  [[nodiscard]] std::string path() const;

  [[nodiscard]] int descriptor() const { return descriptor_; }

  /// Throws what the system says. \errors ErrorKind::cannot_write, always.
  [[noreturn]] void refuse(const char* doing, int error) const;

 private:
  std::string what_;
  int descriptor_ = -1;
};

}  // namespace soms::command
