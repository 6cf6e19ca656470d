#include "apps/cli/terminal.h"

#include "apps/output/output.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <vector>

namespace soms::command {

namespace {

constexpr std::size_t kUsualWidth = 80;
constexpr std::size_t kLeastWidth = 20;  // below it lines are not broken further

std::size_t width_of(int descriptor) {
  if (const char* const columns = std::getenv("COLUMNS")) {
    const std::string_view text = columns;
    std::size_t width = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), width);
    if (error == std::errc() && end == text.data() + text.size() && width > 0) {
      return std::max(width, kLeastWidth);
    }
  }
  winsize size{};
  const bool known = ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? std::max<std::size_t>(size.ws_col, kLeastWidth) : kUsualWidth;
}

std::string_view code_of(Ink ink) {
  switch (ink) {
    case Ink::heading:
      return "\x1b[1m";
    case Ink::touches:
      return "\x1b[1;31m";
    case Ink::free:
      return "\x1b[32m";
    case Ink::open:
      break;
  }
  return "\x1b[33m";
}

/// Where the first character other than a blank is, from `at` on.
std::size_t next_word(std::string_view line, std::size_t at) {
  return std::min(line.find_first_not_of(' ', at), line.size());
}

std::vector<std::string_view> lines_in(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// Where the meaning of an option stands in its line: behind two blanks or more. 0 if nowhere.
std::size_t column_in(std::string_view line) {
  const std::size_t begin = next_word(line, 0);
  const std::size_t gap = line.find("  ", begin);
  return begin == 0 || gap == std::string_view::npos ? 0 : next_word(line, gap);
}

/// A command line, with backslashes where it goes on in the next line.
std::string wrapped_command(std::string_view line, std::size_t width) {
  const std::size_t begin = next_word(line, 0);
  constexpr std::size_t kBackslash = 2;
  std::string text = wrap_words(line.substr(begin), width - begin - kBackslash, 4);
  const std::string margin(begin, ' ');
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at)) {
    text.replace(at, 1, " \\\n" + margin);
    at += margin.size() + 3;
  }
  return margin + text;
}

/// An option with its meaning, which hangs in its column or, where that is narrow, below it.
std::string wrapped_option(std::string_view name, std::string_view meaning, std::size_t column,
                           std::size_t width) {
  constexpr std::size_t kBelow = 6;
  const bool hangs = name.size() + 1 < column && 2 * column <= width;
  const std::size_t at = hangs ? column : kBelow;
  const std::string head = hangs
                               ? std::string(name) + std::string(column - name.size(), ' ')
                               : wrap_words(name, width, kBelow) + "\n" + std::string(kBelow, ' ');
  std::string text = wrap_words(meaning, width - at, 0);
  for (std::size_t end = text.find('\n'); end != std::string::npos;
       end = text.find('\n', end + 1)) {
    text.insert(end + 1, at, ' ');
  }
  return head + text;
}

bool is_heading(std::string_view line) {
  return !line.empty() && line.front() != ' ' && line.back() == ':';
}

bool is_command(std::string_view line) {
  return line.starts_with("  soms");
}

/// Help as lines, some of which belong together: an option with all of its meaning.
class HelpOnTerminal {
 public:
  HelpOnTerminal(const Terminal& terminal, std::string_view help)
      : terminal_(terminal), lines_(lines_in(help)) {}

  std::string text() {
    for (std::size_t k = 0; k < lines_.size();) {
      k = add(k);
    }
    return text_;
  }

 private:
  /// Adds what begins in line `k`; returns where the next begins.
  std::size_t add(std::size_t k) {
    const std::string_view line = lines_[k];
    if (is_heading(line)) {
      in_example_ = line.starts_with("Example");
      text_ += terminal_.paint(line, Ink::heading) + "\n";
      return k + 1;
    }
    if (in_example_ || (is_command(line) && column_in(line) == 0)) {
      // A backslash may be put into a command of soms, but not into a script in quotes.
      text_ += is_command(line) && line.size() > terminal_.width
                   ? wrapped_command(line, terminal_.width)
                   : std::string(line);
      text_ += "\n";
      return k + 1;
    }
    return !line.empty() && line.front() != ' ' ? add_paragraph(k) : add_entry(k);
  }

  std::size_t add_paragraph(std::size_t k) {
    std::string words(lines_[k]);
    std::size_t end = k + 1;
    const auto goes_on = [this](std::string_view line) {
      return !line.empty() && line.front() != ' ' && !is_heading(line) &&
             !line.starts_with("Usage:");
    };
    for (; end < lines_.size() && words.size() > terminal_.width && goes_on(lines_[end]); ++end) {
      words += " " + std::string(lines_[end]);
    }
    text_ += wrap_words(words, terminal_.width, 0) + "\n";
    return end;
  }

  std::size_t add_entry(std::size_t k) {
    const std::string_view first = lines_[k];
    std::size_t column = column_in(first);
    std::size_t end = k + 1;
    // The name of an option that is long has its meaning in the next lines.
    if (column == 0 && first.starts_with("  -") && end < lines_.size()) {
      column = next_word(lines_[end], 0);
    }
    constexpr std::size_t kLeastColumn = 10;
    std::string meaning(column == 0 ? "" : first.substr(std::min(column, first.size())));
    std::size_t longest = first.size();
    while (column >= kLeastColumn && end < lines_.size() && next_word(lines_[end], 0) == column) {
      longest = std::max(longest, lines_[end].size());
      meaning += (meaning.empty() ? "" : " ") + std::string(lines_[end++].substr(column));
    }
    if (longest <= terminal_.width) {
      for (; k < end; ++k) {
        text_ += std::string(lines_[k]) + "\n";
      }
    } else if (column >= kLeastColumn) {
      const std::string_view name = first.substr(0, std::min(column, first.size()));
      text_ += wrapped_option(name.substr(0, name.find_last_not_of(' ') + 1), meaning, column,
                              terminal_.width) +
               "\n";
    } else {
      text_ += wrap_words(first, terminal_.width, next_word(first, 0)) + "\n";
    }
    return end;
  }

  const Terminal& terminal_;
  std::vector<std::string_view> lines_;
  std::string text_;
  bool in_example_ = false;
};

}  // namespace

std::string Terminal::paint(std::string_view text, Ink ink) const {
  return colors && !text.empty() ? std::string(code_of(ink)) + std::string(text) + "\x1b[0m"
                                 : std::string(text);
}

Terminal terminal_of(int descriptor) {
  Terminal terminal{.person = ::isatty(descriptor) == 1, .colors = wants_color(descriptor)};
  terminal.width = terminal.person ? width_of(descriptor) : 0;
  return terminal;
}

Ink ink_of(bool found, bool undecided) {
  return found ? Ink::touches : undecided ? Ink::open : Ink::free;
}

std::string wrap_words(std::string_view text, std::size_t width, std::size_t indent) {
  if (width == 0 || text.size() <= width) {
    return std::string(text);
  }
  const std::size_t first = next_word(text, 0);
  std::string result(text.substr(0, first));
  std::size_t column = first;  // of the line so far
  for (std::size_t at = first; at < text.size();) {
    const std::size_t begin = next_word(text, at);
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (at != first && column + (end - at) > width) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
      at = begin;
    }
    result += text.substr(at, end - at);
    column += end - at;
    at = end;
  }
  return result;
}

std::string help_on(const Terminal& terminal, std::string_view help) {
  return terminal.person ? HelpOnTerminal(terminal, help).text() : std::string(help);
}

}  // namespace soms::command
