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

/// A row under a heading: a name, and what is said of it.
struct Row {
  std::string name;
  std::string text;
};

Row row_of(std::string_view line) {
  line.remove_prefix(indent_of(line));
  const std::size_t end = std::min(line.find("  "), line.size());
  std::string_view name = line.substr(0, end);
  std::string_view text = line.substr(end);
  text.remove_prefix(indent_of(text));
  return {std::string(name), std::string(text)};
}

/// Rows of a block's indented lines; deeper ones continue the row before.
std::vector<Row> rows_of(const Lines& lines) {
  constexpr std::size_t kIndent = 2;
  std::vector<Row> rows;
  for (const std::string_view line : lines) {
    const std::size_t indent = indent_of(line);
    if (indent <= kIndent || rows.empty()) {
      rows.push_back(row_of(line));
      continue;
    }
    std::string& text = rows.back().text;
    text.append(text.empty() || text.ends_with('|') ? "" : " ").append(line.substr(indent));
  }
  return rows;
}

/// "-o,--output FILE": dashes in bold, values in italics.
std::string tag_of(const std::string& name) {
  const bool option = name.starts_with('-');
  const std::string_view view = name;
  const std::size_t space = option ? std::min(view.find(' '), view.size()) : view.size();
  std::string tag;
  for (std::string_view rest = view.substr(0, space); !rest.empty();) {
    const std::string_view one = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(one.size() + 1, rest.size()));
    tag.append(tag.empty() ? "" : ", ").append(bold(one));
  }
  return space == view.size() ? tag : tag + " " + italic(view.substr(space + 1));
}

std::string list(const Lines& lines) {
  std::string out;
  for (const Row& row : rows_of(lines)) {
    out += fmt::format(".TP\n{}\n{}\n", tag_of(row.name), plain(row.text));
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

/// The sections of a page, filled block by block.
struct Sections {
  std::string description;
  std::string arguments;
  std::string options;
  std::string others;
  std::string example;
};

/// "Options:", but not the end of a sentence that leads to a list.
bool is_heading(std::string_view line) {
  return line.ends_with(':') && line.find(". ") == std::string_view::npos;
}

/// A block under a heading: options, an example, or a list of its own.
void add_headed(Sections& sections, const Lines& block) {
  const std::string_view heading = block.front().substr(0, block.front().size() - 1);
  const auto end = std::find_if(block.begin() + 1, block.end(),
                                [](std::string_view line) { return !line.starts_with(' '); });
  const Lines rows(block.begin() + 1, end);
  if (heading.starts_with("Example")) {
    sections.example += as_written(rows);
  } else if (rows.front().substr(indent_of(rows.front())).starts_with('-')) {
    sections.options += fmt::format(".SS {}\n{}", plain(heading), list(rows));
  } else if (heading == "Arguments") {
    sections.arguments += list(rows);
  } else {
    sections.others += fmt::format(".SH {}\n{}", plain(in_capitals(heading)), list(rows));
  }
  if (end != block.end()) {
    sections.description += paragraph(Lines(end, block.end()));
  }
}

Sections sections_of(const std::vector<Lines>& blocks) {
  Sections sections;
  for (const Lines& block : blocks) {
    const bool indented = block.front().starts_with(' ');
    if (block.front().starts_with("Shared options (")) {
      sections.options += paragraph(block);
      continue;
    }
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

}  // namespace

std::string roff(const ManPage& page) {
  std::vector<Lines> blocks = blocks_of(page.help);
  Lines& first = blocks.front();
  std::string_view summary = first.front();
  if (const std::string start = page.name + ": "; summary.starts_with(start)) {
    summary.remove_prefix(start.size());
  }
  std::string out =
      fmt::format(".TH {} 1 \"\" \"soms {}\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n",
                  plain(in_capitals(page.name)), page.version, plain(page.name), plain(summary));
  constexpr std::string_view kUsage = "Usage: ";
  first.erase(first.begin());
  while (!first.empty() && first.front().starts_with(kUsage)) {
    const std::string_view usage = first.front().substr(kUsage.size());
    const std::size_t end = std::min(usage.find_first_of("[<"), usage.size());
    out += fmt::format("{}{}\n", bold(usage.substr(0, end)), plain(usage.substr(end)));
    first.erase(first.begin());
  }
  if (first.empty()) {
    blocks.erase(blocks.begin());
  }
  const Sections sections = sections_of(blocks);
  const auto add = [&out](std::string_view heading, const std::string& text) {
    if (!text.empty()) {
      out += fmt::format(".SH {}\n{}", heading, text);
    }
  };
  add("DESCRIPTION", sections.description);
  add("ARGUMENTS", sections.arguments);
  add("OPTIONS", sections.options);
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
