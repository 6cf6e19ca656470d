/// \file
/// A named pipe that a test writes into.
#pragma once

#include <filesystem>
#include <string>

namespace soms::test {

/// Made in a place where nothing is yet. It stays open for writing until `end`, so that who reads
/// it waits for more.
class Pipe {
 public:
  explicit Pipe(std::filesystem::path path, const std::string& text = {});

  ~Pipe() { end(); }

  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  /// No more than a pipe holds, 64 KiB.
  void give(const std::string& text) const;

  /// Nothing more will come.
  void end();

  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
  int writer_ = -1;
};

}  // namespace soms::test
