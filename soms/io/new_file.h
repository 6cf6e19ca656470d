/// \file
/// A file that appears whole or not at all, whatever ends the program.
#pragma once

#include <filesystem>

namespace soms {

/// A file that is written without a name and takes its name by `commit`, in one step: until then
/// the old file is there, or none, also when the program is killed. Where the file system has no
/// nameless files it is written as `.soms-PID-N.part` in the same folder; such a file, left by a
/// program that was killed, may be deleted. Links are followed, and the permissions of the old file
/// kept where that is allowed. What is no regular file (a pipe, a device) is written straight, and
/// so is what the program has open already (/dev/stdout), from where that stands.
///
/// Errors are given as numbers of the system (`errno`), 0 for none: what they mean is the caller's
/// to say. The bytes may still be in the system's cache when `commit` returns: a computer that
/// loses its power may lose them.
class NewFile {
 public:
  NewFile() = default;
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// Begins; called once.
  [[nodiscard]] int open(const std::filesystem::path& path);

  /// What to write to, between `open` and `commit`.
  [[nodiscard]] int descriptor() const { return descriptor_; }

  /// Gives the file its name; nothing may be written afterwards.
  [[nodiscard]] int commit();

 private:
  [[nodiscard]] int open_nameless();
  [[nodiscard]] int open_beside();
  [[nodiscard]] int give_name();

  std::filesystem::path target_;  ///< links followed; empty where the file is written straight
  std::filesystem::path beside_;  ///< name until `commit`; empty while there is none
  int descriptor_ = -1;
};

}  // namespace soms
