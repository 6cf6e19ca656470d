#include "soms/io/detail/source.h"

#include <algorithm>

namespace soms::detail {

void Source::tick(std::size_t position) const {
  check_stop(parallel);
  if (parallel.progress && !bytes.empty()) {
    parallel.progress(static_cast<double>(position) / static_cast<double>(bytes.size()));
  }
}

void Source::fail_memory(std::uint64_t wanted) const {
  fail(ErrorKind::out_of_memory,
       "reading needs " + std::to_string(wanted) + " bytes more than its limit leaves",
       "raise the limit (max_memory, --max-memory) if the file is honest");
}

void Source::fail(ErrorKind kind, const std::string& what, const std::string& remedy) const {
  throw Error(kind, name + ": " + what, remedy);
}

void Source::fail_line(std::size_t position, ErrorKind kind, const std::string& what,
                       const std::string& remedy) const {
  throw Error(kind, name + ", line " + std::to_string(line_of(bytes, position)) + ": " + what,
              remedy);
}

void Source::fail_byte(std::size_t position, ErrorKind kind, const std::string& what,
                       const std::string& remedy) const {
  throw Error(kind, name + ", byte " + std::to_string(position + skipped) + ": " + what, remedy);
}

std::size_t line_of(std::string_view bytes, std::size_t position) {
  std::size_t line = 1;
  const std::size_t end = std::min(position, bytes.size());
  for (std::size_t i = 0; i < end; ++i) {
    const bool pair = bytes[i] == '\r' && i + 1 < bytes.size() && bytes[i + 1] == '\n';
    line += bytes[i] == '\n' || (bytes[i] == '\r' && !pair) ? 1U : 0U;
  }
  return line;
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kMost = 40;
  std::string text = "\"";
  for (const char c : word.substr(0, kMost)) {
    text += c >= ' ' && c <= '~' ? c : '?';
  }
  return text + (word.size() > kMost ? "...\"" : "\"");
}

}  // namespace soms::detail
