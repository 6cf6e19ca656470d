#include "apps/view/control/file_list.h"

#include "soms/base/text.h"
#include "soms/io/formats.h"

#include <algorithm>
#include <cctype>
#include <system_error>
#include <tuple>

namespace soms::view {

namespace {

namespace fs = std::filesystem;

char lower_case(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

/// Rows of a folder; an entry that cannot be looked at is left out.
std::vector<FileRow> rows_of(const fs::path& folder, std::error_code& fault) {
  std::vector<FileRow> rows;
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
       entry.increment(fault)) {
    const std::string name = entry->path().filename().string();
    std::error_code unknown;
    const bool is_folder = entry->is_directory(unknown);
    if (name.front() != '.' && (is_folder || (is_named_as_model(entry->path()) && !unknown))) {
      rows.push_back({entry->path(), printable(name) + (is_folder ? "/" : ""), is_folder});
    }
  }
  std::sort(rows.begin(), rows.end(), [](const FileRow& a, const FileRow& b) {
    return std::tuple(!a.folder, a.text) < std::tuple(!b.folder, b.text);
  });
  return rows;
}

}  // namespace

void FileList::enter(const fs::path& folder) {
  std::error_code fault;
  folder_ = fs::weakly_canonical(folder, fault);
  rows_ = rows_of(folder_, fault);
  fault_ = fault ? fault.message() : "";
  chosen_ = 0;
}

void FileList::choose(std::size_t row) {
  chosen_ = std::min(row, rows_.empty() ? 0 : rows_.size() - 1);
}

void FileList::move(int by) {
  const auto back = static_cast<std::size_t>(std::max(-by, 0));
  choose(by < 0 ? chosen_ - std::min(chosen_, back) : chosen_ + static_cast<std::size_t>(by));
}

void FileList::jump(char letter) {
  for (std::size_t i = 1; i <= rows_.size(); ++i) {
    const std::size_t row = (chosen_ + i) % rows_.size();
    if (lower_case(rows_[row].text.front()) == lower_case(letter)) {
      chosen_ = row;
      return;
    }
  }
}

void FileList::up() {
  const fs::path from = folder_;
  enter(folder_.parent_path());
  const auto row =
      std::find_if(rows_.begin(), rows_.end(), [&](const FileRow& r) { return r.path == from; });
  choose(row == rows_.end() ? 0 : static_cast<std::size_t>(row - rows_.begin()));
}

std::optional<fs::path> FileList::go_to(const std::string& text) {
  const fs::path path = folder_ / text;
  std::error_code unknown;
  if (fs::is_regular_file(path, unknown)) {
    return path;
  }
  enter(path);
  return std::nullopt;
}

std::optional<fs::path> FileList::open() {
  if (rows_.empty()) {
    return std::nullopt;
  }
  const FileRow row = rows_[chosen_];
  if (!row.folder) {
    return row.path;
  }
  enter(row.path);
  return std::nullopt;
}

}  // namespace soms::view
