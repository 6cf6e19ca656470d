#include "soms/io/detail/numbers/line_reader.h"

#include "soms/base/error.h"
#include "soms/io/detail/source.h"
#include "soms/io/encoding.h"

#include <algorithm>
#include <utility>

namespace soms::detail {

namespace {

constexpr std::size_t kFirstSize = std::size_t{1} << 16;
constexpr std::size_t kLongestLine = std::size_t{1} << 20;

}  // namespace

LineReader::LineReader(const std::filesystem::path& path, const Limits& limits)
    : name_(path.string()),
      limits_{.stop = limits.stop},
      file_(open_for_reading(path)),
      buffer_(kFirstSize) {
  while (end_ < kByteOrderMark.size() && !at_end_) {
    fill();
  }
  const std::string_view start(buffer_.data(), end_);
  refuse_utf16(start, name_);
  if (start.starts_with(kByteOrderMark)) {
    begin_ = kByteOrderMark.size();
  }
}

LineReader::LineReader(std::string name, std::vector<char> bytes)
    : name_(std::move(name)),
      file_(-1),
      buffer_(std::move(bytes)),
      end_(buffer_.size()),
      at_end_(true) {
}

/// Adds bytes behind those that are left, or finds the end of the file.
void LineReader::fill() {
  if (begin_ > 0) {
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == buffer_.size()) {
    if (end_ >= kLongestLine) {
      throw Error(ErrorKind::bad_file,
                  name_ + ", line " + std::to_string(number_ + 1) + ": longer than 1 MiB",
                  "give a text file with one row per line");
    }
    buffer_.resize(2 * buffer_.size());
  }
  const std::size_t got =
      read_some(name_, file_.get(), buffer_.data() + end_, buffer_.size() - end_, limits_);
  end_ += got;
  at_end_ = got == 0;
}

/// True if the buffer holds a whole line; it is `looked_at_` bytes long then.
bool LineReader::find_end() {
  if (after_carriage_return_ && begin_ != end_) {
    begin_ += buffer_[begin_] == '\n' ? 1U : 0U;
    after_carriage_return_ = false;
  }
  const auto line = buffer_.begin() + static_cast<std::ptrdiff_t>(begin_);
  const auto to = buffer_.begin() + static_cast<std::ptrdiff_t>(end_);
  const auto found = std::find_if(line + static_cast<std::ptrdiff_t>(looked_at_), to,
                                  [](char c) { return c == '\n' || c == '\r'; });
  looked_at_ = static_cast<std::size_t>(found - line);
  return found != to;
}

bool LineReader::ready() {
  while (!find_end() && !at_end_) {
    if (!is_readable(file_.get())) {
      return false;
    }
    fill();
  }
  return true;
}

std::optional<std::string_view> LineReader::next() {
  bool whole = find_end();
  while (!whole && !at_end_) {
    fill();
    whole = find_end();
  }
  if (!whole && begin_ == end_) {
    return std::nullopt;
  }
  const std::string_view line(buffer_.data() + begin_, looked_at_);
  begin_ += line.size();
  if (whole) {  // else the last line lacks its end
    after_carriage_return_ = buffer_[begin_] == '\r';
    ++begin_;
  }
  looked_at_ = 0;
  ++number_;
  return line;
}

bool LineReader::starts_with(std::string_view start) {
  const auto there = [&] { return std::string_view(buffer_.data() + begin_, end_ - begin_); };
  while (there().size() < start.size() && start.starts_with(there()) && !at_end_) {
    fill();
  }
  return there().starts_with(start);
}

std::string_view LineReader::bytes(std::size_t count) {
  while (end_ - begin_ < count && !at_end_) {
    fill();
  }
  const std::string_view piece(buffer_.data() + begin_, std::min(count, end_ - begin_));
  begin_ += piece.size();
  looked_at_ = 0;
  return piece;
}

bool LineReader::has_bytes(std::size_t count) {
  while (end_ - begin_ < count && !at_end_) {
    if (!is_readable(file_.get())) {
      return false;
    }
    fill();
  }
  return true;
}

}  // namespace soms::detail
