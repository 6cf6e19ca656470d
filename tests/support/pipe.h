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

  /// True where it holds all that it can, so that who writes into it waits.
  [[nodiscard]] bool is_full() const;

  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
  int writer_ = -1;
};

/// A named pipe with a line at its head and then one and the same line without end, so that a
/// program that reads it is never done.
class EndlessPipe {
 public:
  EndlessPipe(std::filesystem::path path, const std::string& head, const std::string& line);
  ~EndlessPipe();
  EndlessPipe(const EndlessPipe&) = delete;
  EndlessPipe& operator=(const EndlessPipe&) = delete;

  [[nodiscard]] std::string path() const { return pipe_.path(); }

 private:
  Pipe pipe_;
  int writer_ = -1;  ///< process
};

}  // namespace soms::test
