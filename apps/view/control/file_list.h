/// \file
/// A folder to choose a model from: its folders and the files that can be read.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace soms::view {

struct FileRow {
  std::filesystem::path path;
  std::string text;  ///< its name, printable; of folders with a slash at the end
  bool folder = false;

  [[nodiscard]] bool operator==(const FileRow&) const = default;
};

/// One folder at a time, with one row chosen.
class FileList {
 public:
  explicit FileList(const std::filesystem::path& folder) { enter(folder); }

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// Folders, then files with the extension of a format that is read; each by name. Hidden ones are
  /// left out.
  [[nodiscard]] const std::vector<FileRow>& rows() const { return rows_; }

  /// Why there are no rows; empty: there may be some.
  [[nodiscard]] const std::string& fault() const { return fault_; }

  [[nodiscard]] std::size_t chosen() const { return chosen_; }

  /// Chooses a row, at most the last.
  void choose(std::size_t row);

  /// Chooses the row so many below; stops at the ends.
  void move(int by);

  /// Chooses the next row that begins with a letter, in either case, and round.
  void jump(char letter);

  /// To the folder that this one is in.
  void up();

  /// Enters the folder of a path, which begins at this one unless it is whole, or gives its file.
  /// Where there is neither, `fault` says so.
  [[nodiscard]] std::optional<std::filesystem::path> go_to(const std::string& text);

  /// Enters the folder chosen, or gives the file chosen.
  [[nodiscard]] std::optional<std::filesystem::path> open();

 private:
  void enter(const std::filesystem::path& folder);

  std::filesystem::path folder_;
  std::vector<FileRow> rows_;
  std::string fault_;
  std::size_t chosen_ = 0;
};

}  // namespace soms::view
