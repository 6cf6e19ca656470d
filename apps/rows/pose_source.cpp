#include "apps/rows/pose_source.h"

#include "soms/base/text.h"

#include "apps/cli/console.h"
#include "apps/cli/standard_input.h"
#include "apps/rows/npy_part.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <string_view>

namespace soms::command {

namespace {

/// True if the first word is a number (or nan, inf): then the text is meant as a pose.
bool looks_like_pose(std::string_view text) {
  constexpr std::string_view kSpace = " \t,";
  const std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == std::string_view::npos) {
    return true;
  }
  text.remove_prefix(begin);
  std::string_view word = text.substr(0, text.find_first_of(kSpace));
  if (word.starts_with('+')) {
    word.remove_prefix(1);
  }
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error != std::errc::invalid_argument && end == word.data() + word.size();
}

}  // namespace

PoseSource::PoseSource(const std::string& option, const std::string& text, const Console& console,
                       NoRows no_rows)
    : name_(text == "-" ? kStandardInputName : text), console_(&console) {
  std::error_code ignored;
  if (text != "-" && looks_like_pose(text) && !std::filesystem::exists(text, ignored)) {
    try {
      first_ = parse_pose(text);
    } catch (const Error& error) {
      throw Error(error.kind(), option + ": " + error.place(), error.remedy());
    }
    constant_ = true;
    name_ = option;
    return;
  }
  if (text == "-") {
    check_standard_input("poses");
  }
  open(text == "-" ? std::string(kStandardInput) : text);
  first_ = read();
  if (!first_ && no_rows == NoRows::refused) {
    throw Error(ErrorKind::bad_file, name_ + ": no rows",
                "give at least one pose below the header");
  }
  if (!first_) {
    console_->note(printable(name_) + ": no rows");
    constant_ = false;
  }
}

PoseSource::PoseSource(const std::string& option, const std::string& text, const Console& console,
                       const RowRange& part)
    : name_(text), console_(&console) {
  const std::optional<NpyLayout> layout = npy_layout(text);
  if (!layout) {
    *this = PoseSource(option, text, console, NoRows::no_poses);
    for (std::uint64_t row = 0; row < part.begin && next(); ++row) {
    }
    return;
  }
  part_.emplace(npy_part(text, *layout, part));
  part_begin_ = part.begin;
  open(part_->path());
  first_ = read();
  constant_ = false;
}

void PoseSource::open(const std::string& path) {
  try {
    reader_.emplace(path, console_->limited());
  } catch (const Error& error) {
    fail(error);
  }
}

std::optional<Pose> PoseSource::read() {
  try {
    return reader_->next();
  } catch (const Error& error) {
    fail(error);
  }
}

/// Throws what the reader threw, in the words of this option.
void PoseSource::fail(const Error& error) const {
  if (error.kind() == ErrorKind::cancelled && !console_->interrupted()) {
    throw Error(ErrorKind::timed_out, "out of time while reading poses from " + name_,
                "allow more time with --timeout");
  }
  if (name_ == kStandardInputName) {
    throw of_standard_input(error);
  }
  if (error.kind() == ErrorKind::cannot_open) {
    throw Error(error.kind(), error.place(), "name a file, or give a pose as \"x y z\"");
  }
  throw of_whole_file(error);
}

/// An error that names the part, and a row of it, as one of the file that it is from.
Error PoseSource::of_whole_file(const Error& error) const {
  std::string place = error.place();
  if (!part_ || !place.starts_with(part_->path())) {
    return error;
  }
  constexpr std::string_view kRow = ", row ";
  place = place.substr(part_->path().size());
  if (std::uint64_t row = 0; place.starts_with(kRow)) {
    const auto [end, unread] =
        std::from_chars(place.data() + kRow.size(), place.data() + place.size(), row);
    place = fmt::format("{}{}{}", kRow, part_begin_ + row, end);
  }
  return {error.kind(), name_ + place, error.remedy()};
}

bool PoseSource::is_constant() {
  if (!constant_) {
    try {
      second_ = read();
      constant_ = !second_;
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cancelled) {
        throw;
      }
      error_ = std::current_exception();
      constant_ = false;
    }
  }
  return *constant_;
}

std::optional<Pose> PoseSource::next() {
  if (!first_given_) {
    first_given_ = true;
    return first_;
  }
  if (is_constant()) {
    return first_;
  }
  if (error_) {
    std::rethrow_exception(error_);
  }
  if (second_) {
    return std::exchange(second_, std::nullopt);
  }
  return read();
}

bool PoseSource::ready() {
  return !first_given_ || second_ || error_ || constant_.value_or(false) || reader_->ready();
}

std::optional<std::uint64_t> count_poses(const std::string& option, const std::string& text,
                                         const Console& console) {
  if (const std::optional<NpyLayout> layout = npy_layout(text)) {
    return layout->rows == 1 ? std::nullopt : std::optional(layout->rows);
  }
  PoseSource poses(option, text, console, NoRows::no_poses);
  if (poses.is_stated() || poses.is_constant()) {
    return std::nullopt;
  }
  std::uint64_t rows = 0;
  while (poses.next()) {
    ++rows;
  }
  return rows;
}

std::optional<std::pair<Pose, Pose>> PosePairs::next() {
  if (rows_ == most_) {
    return std::nullopt;
  }
  if (rows_ == 1 && is_single()) {
    return std::nullopt;
  }
  const std::optional<Pose> a = a_.next();
  const std::optional<Pose> b = b_.next();
  if (a && b) {
    ++rows_;
    return std::pair(*a, *b);
  }
  if ((a && !a_.is_constant()) || (b && !b_.is_constant())) {
    const PoseSource& shorter = a ? b_ : a_;
    const PoseSource& longer = a ? a_ : b_;
    throw Error(
        ErrorKind::bad_file,
        fmt::format("{}: has {} poses, but {} has more", shorter.name(), rows_, longer.name()),
        "give the same number of poses in both, or a single pose for one of them");
  }
  return std::nullopt;
}

}  // namespace soms::command
