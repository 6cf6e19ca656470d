#include "soms/io/detail/line_reader.h"

#include "soms/base/error.h"

#include <algorithm>

namespace soms::detail {

namespace {

constexpr std::size_t kFirstSize = std::size_t{1} << 16;
constexpr std::size_t kLongestLine = std::size_t{1} << 20;

}  // namespace

LineReader::LineReader(const std::filesystem::path& path, const Parallel& parallel)
    : name_(path.string()),
      parallel_{.stop = parallel.stop},
      file_(open_for_reading(path)),
      buffer_(kFirstSize) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  while (end_ < kByteOrderMark.size() && fill()) {
  }
  if (std::string_view(buffer_.data(), end_).starts_with(kByteOrderMark)) {
    begin_ = kByteOrderMark.size();
  }
}

/// Adds bytes behind those that are left; false at the end of the file.
bool LineReader::fill() {
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
                  "give a text file with one row a line");
    }
    buffer_.resize(2 * buffer_.size());
  }
  const std::size_t got =
      read_some(name_, file_.get(), buffer_.data() + end_, buffer_.size() - end_, parallel_);
  end_ += got;
  return got > 0;
}

std::optional<std::string_view> LineReader::next() {
  std::size_t looked_at = 0;
  while (true) {
    if (after_carriage_return_ && begin_ != end_) {
      begin_ += buffer_[begin_] == '\n' ? 1U : 0U;
      after_carriage_return_ = false;
    }
    const auto from = buffer_.begin() + static_cast<std::ptrdiff_t>(begin_ + looked_at);
    const auto to = buffer_.begin() + static_cast<std::ptrdiff_t>(end_);
    const auto found = std::find_if(from, to, [](char c) { return c == '\n' || c == '\r'; });
    const std::string_view line(buffer_.data() + begin_,
                                static_cast<std::size_t>(found - buffer_.begin()) - begin_);
    if (found != to) {
      after_carriage_return_ = *found == '\r';
      begin_ += line.size() + 1;
      ++number_;
      return line;
    }
    looked_at = line.size();
    if (!fill()) {
      if (begin_ == end_) {
        return std::nullopt;
      }
      // The last line lacks its end. Filling may have moved it to the front.
      const std::string_view last(buffer_.data() + begin_, end_ - begin_);
      begin_ = end_;
      ++number_;
      return last;
    }
  }
}

}  // namespace soms::detail
