/// \file
/// A folder for files between two programs.
#pragma once

#include <filesystem>
#include <string_view>

namespace soms::command {

/// A new folder of this user alone, removed with all that is in it when the object ends.
class TemporaryFolder {
 public:
  /// `what` is to be in it, for the message.
  /// \errors ErrorKind::cannot_write.
  explicit TemporaryFolder(std::string_view what);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace soms::command
