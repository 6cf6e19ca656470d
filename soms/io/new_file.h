/// \file
/// A file that appears whole or not at all, whatever ends the program.
#pragma once

#include <cstdint>
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
///
/// Of a file with several names (hard links) only the name that is given becomes the new file; the
/// others keep the old one. So a model may be written over another name of the model that is read,
/// and a copy that a backup shares by a link stays as it was.
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

  /// How many other names (hard links) the old file has, which will keep it; 0 where nothing is
  /// replaced.
  [[nodiscard]] std::uint64_t other_names() const { return other_names_; }

  /// Gives the file its name; nothing may be written afterwards.
  [[nodiscard]] int commit();

 private:
  [[nodiscard]] int open_nameless();
  [[nodiscard]] int open_beside();
  [[nodiscard]] int give_name();

  std::filesystem::path target_;  ///< links followed; empty where the file is written straight
  std::filesystem::path beside_;  ///< name until `commit`; empty while there is none
  int descriptor_ = -1;
  std::uint64_t other_names_ = 0;
};

}  // namespace soms
