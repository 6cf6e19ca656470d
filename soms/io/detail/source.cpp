#include "soms/io/detail/source.h"

#include "soms/base/text.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>

namespace soms::detail {

void Source::tick(std::size_t position) const {
  check(limits);
  if (limits.progress && !bytes.empty()) {
    limits.progress(static_cast<double>(position) / static_cast<double>(bytes.size()));
  }
}

void Source::forget(std::size_t position) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 20;
  if (!forgettable || position < forgotten + kAtOnce) {
    return;
  }
  forgotten_line_ends += count_line_ends(bytes, forgotten, position);
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto begin = reinterpret_cast<std::uintptr_t>(bytes.data());
  // Whole pages: bytes beside them belong to others, or are still to be read.
  const std::uintptr_t first =
      std::max((begin + kept + page - 1) / page, (begin + forgotten) / page);
  const std::uintptr_t behind = (begin + position) / page;
  if (behind > first) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): a page's place is found by its number
    madvise(reinterpret_cast<void*>(first * page), (behind - first) * page, MADV_DONTNEED);
  }
  forgotten = position;
}

void Source::fail_memory(std::uint64_t wanted) const {
  fail(ErrorKind::out_of_memory,
       "reading exceeds the memory limit by at least " +
           readable_bytes(wanted - std::min(wanted, budget.left())),
       "raise the limit (max_memory) if the file can be trusted");
}

void Source::fail(ErrorKind kind, const std::string& what, const std::string& remedy) const {
  throw Error(kind, name + ": " + what, remedy);
}

std::string Source::line_of(std::size_t position) const {
  const std::size_t end = std::min(position, bytes.size());
  return "line " + std::to_string(1 + forgotten_line_ends + count_line_ends(bytes, forgotten, end));
}

std::string Source::byte_of(std::size_t position) const {
  return "byte " + std::to_string(position + skipped);
}

void Source::fail_line(std::size_t position, ErrorKind kind, const std::string& what,
                       const std::string& remedy) const {
  throw Error(kind, name + ", " + line_of(position) + ": " + what, remedy);
}

void Source::fail_byte(std::size_t position, ErrorKind kind, const std::string& what,
                       const std::string& remedy) const {
  throw Error(kind, name + ", " + byte_of(position) + ": " + what, remedy);
}

void skip_byte_order_mark(Source& source) {
  if (source.bytes.starts_with(kByteOrderMark)) {
    source.skipped = kByteOrderMark.size();
    source.bytes.remove_prefix(source.skipped);
  }
}

namespace {

/// As std::count, but in steps of which a processor counts many at once.
std::size_t count_of(char wanted, std::string_view text) {
  constexpr std::size_t kStep = 128;
  std::size_t count = 0;
  for (; text.size() >= kStep; text.remove_prefix(kStep)) {
    std::uint8_t here = 0;
    for (std::size_t i = 0; i < kStep; ++i) {
      here = static_cast<std::uint8_t>(here + (text[i] == wanted ? 1 : 0));
    }
    count += here;
  }
  return count + static_cast<std::size_t>(std::count(text.begin(), text.end(), wanted));
}

}  // namespace

std::size_t count_line_ends(std::string_view bytes, std::size_t begin, std::size_t end) {
  const std::string_view part = bytes.substr(begin, end - begin);
  std::size_t count = count_of('\n', part);
  for (std::size_t i = part.find('\r'); i != std::string_view::npos; i = part.find('\r', i + 1)) {
    const std::size_t next = begin + i + 1;
    count += next == bytes.size() || bytes[next] != '\n' ? 1U : 0U;
  }
  return count;
}

std::string in_quotes(std::string_view token) {
  constexpr std::size_t kMost = 40;
  std::string text = "\"";
  for (const char c : token.substr(0, kMost)) {
    text += c >= ' ' && c <= '~' ? c : '?';
  }
  return text + (token.size() > kMost ? "...\"" : "\"");
}

}  // namespace soms::detail
