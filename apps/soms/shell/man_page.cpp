#include "apps/soms/shell/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace soms::command {

namespace {

using Lines = std::vector<std::string_view>;

/// Text that means itself: dashes stay dashes when copied, and no line is taken for a request.
std::string plain(std::string_view text) {
  std::string out;
  if (text.starts_with('.') || text.starts_with('\'')) {
    out += "\\&";
  }
  for (const char c : text) {
    switch (c) {
      case '\\':
        out += "\\(rs";
        break;
      case '-':
        out += "\\-";
        break;
      case '\'':
        out += "\\(aq";
        break;
      case '`':
        out += "\\(ga";
        break;
      case '^':
        out += "\\(ha";
        break;
      case '~':
        out += "\\(ti";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string bold(std::string_view text) {
  return fmt::format("\\fB{}\\fR", plain(text));
}

std::string italic(std::string_view text) {
  return fmt::format("\\fI{}\\fR", plain(text));
}

std::size_t indent_of(std::string_view line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

/// Groups of lines between empty ones.
std::vector<Lines> blocks_of(std::string_view text) {
  std::vector<Lines> blocks;
  bool apart = true;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.empty()) {
      apart = true;
      continue;
    }
    if (apart) {
      blocks.emplace_back();
      apart = false;
    }
    blocks.back().push_back(line);
  }
  return blocks;
}

/// A line below a heading of the text: a name, and behind two blanks what is said of it.
ManRow row_of(std::string_view line) {
  line.remove_prefix(indent_of(line));
  const std::size_t end = std::min(line.find("  "), line.size());
  std::string_view text = line.substr(end);
  text.remove_prefix(indent_of(text));
  return {.names = {std::string(line.substr(0, end))}, .text = std::string(text)};
}

/// Rows of a block's indented lines; deeper ones continue the row before.
std::vector<ManRow> rows_of(const Lines& lines) {
  constexpr std::size_t kIndent = 2;
  std::vector<ManRow> rows;
  for (const std::string_view line : lines) {
    const std::size_t indent = indent_of(line);
    if (indent <= kIndent || rows.empty()) {
      rows.push_back(row_of(line));
      continue;
    }
    std::string& text = rows.back().text;
    text.append(text.empty() ? "" : " ").append(line.substr(indent));
  }
  return rows;
}

/// "-o, --output FILE": names in bold, values in italics. Of a key "rule=NAME".
std::string tag_of(const ManRow& row) {
  std::string tag;
  for (const std::string& name : row.names) {
    tag.append(tag.empty() ? "" : ", ").append(bold(name));
  }
  return row.value.empty() ? tag : tag + (tag.ends_with("=\\fR") ? "" : " ") + italic(row.value);
}

std::string list(const std::vector<ManRow>& rows) {
  std::string out;
  for (const ManRow& row : rows) {
    out += fmt::format(".TP\n{}\n{}\n", tag_of(row), plain(row.text));
  }
  return out;
}

std::string as_written(const Lines& lines) {
  std::string out = ".nf\n";
  for (const std::string_view line : lines) {
    out += plain(line.substr(std::min<std::size_t>(indent_of(line), 2))) + "\n";
  }
  return out + ".fi\n";
}

/// Lines of a paragraph; indented ones among them keep their form.
std::string paragraph(const Lines& lines) {
  std::string out = ".PP\n";
  for (auto at = lines.begin(); at != lines.end();) {
    const bool indented = at->starts_with(' ');
    const auto end = std::find_if(
        at, lines.end(), [&](std::string_view line) { return line.starts_with(' ') != indented; });
    if (indented) {
      out += as_written(Lines(at, end));
    } else {
      for (auto line = at; line != end; ++line) {
        out += plain(*line) + "\n";
      }
    }
    at = end;
  }
  return out;
}

std::string in_capitals(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return out;
}

/// The sections that a text fills block by block.
struct Sections {
  std::string description;
  std::string others;
  std::string example;
};

/// "Statuses:", but not the end of a sentence that leads to a list.
bool is_heading(std::string_view line) {
  return line.ends_with(':') && line.find(". ") == std::string_view::npos;
}

/// A block under a heading: an example, or a list of its own.
void add_headed(Sections& sections, const Lines& block) {
  const std::string_view heading = block.front().substr(0, block.front().size() - 1);
  const auto end = std::find_if(block.begin() + 1, block.end(),
                                [](std::string_view line) { return !line.starts_with(' '); });
  const Lines rows(block.begin() + 1, end);
  if (heading.starts_with("Example")) {
    sections.example += as_written(rows);
  } else {
    sections.others += fmt::format(".SH {}\n{}", plain(in_capitals(heading)), list(rows_of(rows)));
  }
  if (end != block.end()) {
    sections.description += paragraph(Lines(end, block.end()));
  }
}

Sections sections_of(std::string_view text) {
  Sections sections;
  for (const Lines& block : blocks_of(text)) {
    const bool indented = block.front().starts_with(' ');
    if (indented && !sections.example.empty()) {
      sections.example += as_written(block);
    } else if (block.size() > 1 && is_heading(block[0]) && block[1].starts_with(' ')) {
      add_headed(sections, block);
    } else {
      sections.description += paragraph(block);
    }
  }
  return sections;
}

std::string options_of(const ManPage& page) {
  std::string out;
  for (const ManList& group : page.options) {
    out += fmt::format(".SS {}\n{}", plain(group.heading), list(group.rows));
  }
  return page.shared.empty() ? out : out + ".PP\n" + plain(page.shared) + "\n";
}

}  // namespace

std::string roff(const ManPage& page) {
  std::string out =
      fmt::format(".TH {} 1 \"\" \"soms {}\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{} {}\n",
                  plain(in_capitals(page.name)), page.version, plain(page.name),
                  plain(page.summary), bold(page.command), plain(page.words));
  const Sections sections = sections_of(page.text);
  const auto add = [&out](std::string_view heading, const std::string& text) {
    if (!text.empty()) {
      out += fmt::format(".SH {}\n{}", heading, text);
    }
  };
  add("DESCRIPTION", sections.description);
  add("ARGUMENTS", list(page.arguments));
  add("OPTIONS", options_of(page));
  for (const ManList& one : page.lists) {
    add(plain(in_capitals(one.heading)), list(one.rows));
  }
  out += sections.others;
  add("EXAMPLE", sections.example);
  std::string others;
  for (const std::string& name : page.see_also) {
    others += fmt::format("{}{}(1)", others.empty() ? "" : ",\n", bold(name));
  }
  add("SEE ALSO", others.empty() ? others : others + "\n");
  return out;
}

}  // namespace soms::command
