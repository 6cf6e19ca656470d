#include "soms/io/detail/collada/xml_document.h"

#include "soms/io/detail/text.h"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

namespace soms::detail {

namespace {

/// Memory of pugixml for an element or a text, for an attribute, and for its pages.
constexpr std::uint64_t kBytesPerNode = 64;
constexpr std::uint64_t kBytesPerAttribute = 40;
constexpr std::uint64_t kBytesOfPages = std::uint64_t{128} << 10;

/// Line ends are left as they are, so that places in texts are places in the file.
constexpr unsigned kParsing =
    pugi::parse_cdata | pugi::parse_escapes | pugi::parse_wconv_attribute | pugi::parse_doctype;

/// Where a reference to a character begins of which pugixml makes a zero byte: its number is 0 by
/// the 32 bits that pugixml keeps of it.
std::size_t find_zero(std::string_view text) {
  for (std::size_t at = text.find("&#"); at != text.npos; at = text.find("&#", at + 1)) {
    const bool is_hex = text.substr(at + 2).starts_with('x');
    const std::size_t begin = at + (is_hex ? 3 : 2);
    const std::size_t end =
        text.find_first_not_of(is_hex ? "0123456789abcdefABCDEF" : "0123456789", begin);
    if (end == text.npos || end == begin || text[end] != ';') {
      continue;
    }
    std::uint32_t number = 0;
    for (const char c : text.substr(begin, end - begin)) {
      const int digit = c <= '9' ? c - '0' : (c | ' ') - 'a' + 10;
      number = (is_hex ? 16 : 10) * number + static_cast<std::uint32_t>(digit);
    }
    if (number == 0) {
      return at;
    }
  }
  return text.npos;
}

/// A tag, the text between two, or what is taken as it stands: a comment, a CDATA section or a
/// processing instruction.
struct Piece {
  std::string_view text;
  bool is_plain = false;
};

/// The first piece of what was parsed and begins with one.
Piece first_piece(std::string_view bytes) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kPlain = {
      {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}}};
  for (const auto& [begin, end] : kPlain) {
    if (bytes.starts_with(begin)) {
      const std::size_t at = bytes.find(end, begin.size());
      return {bytes.substr(0, at == bytes.npos ? at : at + end.size()), true};
    }
  }
  if (!bytes.starts_with('<')) {
    return {bytes.substr(0, bytes.find('<')), false};
  }
  char quote = '\0';
  for (std::size_t i = 1; i < bytes.size(); ++i) {
    const char c = bytes[i];
    if (quote != '\0') {
      quote = c == quote ? '\0' : quote;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return {bytes.substr(0, i + 1), false};
    }
  }
  return {bytes, false};
}

}  // namespace

std::size_t offset_of(pugi::xml_node node) {
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, node.offset_debug()));
}

std::string describe(pugi::xml_node element) {
  std::string text = "<";
  text += element.name();
  if (const pugi::xml_attribute id = element.attribute("id")) {
    text += " id=";
    text += in_quotes(id.value());
  }
  text += '>';
  return text;
}

XmlDocument::XmlDocument(Source& source, std::string_view root_name) : source_(source) {
  parse();
  refuse_entities();
  const pugi::xml_node last = document_.last_child();
  if (root().name() != root_name) {
    fail(root(), "the file begins with " + describe(root()) + ", not with <" +
                     std::string(root_name) + ">");
  }
  for (pugi::xml_node node = root(); node != last;) {
    node = node.next_sibling();
    if (node.type() == pugi::node_element) {
      fail(node, "a second root element, " + describe(node) + ", follows the first");
    }
  }
  refuse_zeros();
}

/// pugixml takes no limit, so what it may need is taken before: a text, and at most one element
/// and one text for each <, one attribute for each =.
void XmlDocument::parse() {
  const std::string_view bytes = source_.bytes;
  const auto tags = static_cast<std::uint64_t>(std::count(bytes.begin(), bytes.end(), '<'));
  const auto attributes = static_cast<std::uint64_t>(std::count(bytes.begin(), bytes.end(), '='));
  take(bytes.size() + 2 * kBytesPerNode * tags + kBytesPerAttribute * attributes + kBytesOfPages);
  const pugi::xml_parse_result result =
      document_.load_buffer(bytes.data(), bytes.size(), kParsing, pugi::encoding_utf8);
  if (result.status == pugi::status_out_of_memory) {
    throw std::bad_alloc();
  }
  if (!result) {
    source_.fail_line(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, result.offset)),
                      ErrorKind::bad_file,
                      std::string("not well-formed XML: ") + result.description(),
                      "get the complete file, or repair it");
  }
}

/// pugixml expands no entities but XML's five, so a file that needs its own would be misread.
void XmlDocument::refuse_entities() const {
  for (const pugi::xml_node node : document_.children()) {
    if (node.type() == pugi::node_doctype &&
        std::string_view(node.value()).find("<!ENTITY") != std::string_view::npos) {
      fail(node, "the file declares entities of its own, which are not expanded",
           "export it without entities", ErrorKind::unsupported);
    }
  }
}

/// A reference to the character 0, which XML does not have, would end a text or an attribute early.
/// In comments and the like it is none.
void XmlDocument::refuse_zeros() const {
  const std::string_view bytes = source_.bytes;
  if (find_zero(bytes) == std::string_view::npos) {
    return;
  }
  const std::size_t name = offset_of(root());
  for (std::size_t at = name > 0 ? name - 1 : 0; at < bytes.size();) {
    const Piece piece = first_piece(bytes.substr(at));
    const std::size_t zero = piece.is_plain ? piece.text.npos : find_zero(piece.text);
    if (zero != piece.text.npos) {
      source_.fail_line(at + zero, ErrorKind::bad_file,
                        "not well-formed XML: it refers to the character 0", kRepairFile);
    }
    at += piece.text.size();
  }
}

void XmlDocument::take(std::uint64_t bytes) const {
  if (!source_.budget.take(bytes)) {
    source_.fail_memory(bytes);
  }
}

std::string XmlDocument::place_of(pugi::xml_node element) const {
  return "in " + source_.line_of(offset_of(element));
}

void XmlDocument::fail(pugi::xml_node at, const std::string& what, const std::string& remedy,
                       ErrorKind kind) const {
  source_.fail_line(offset_of(at), kind, what, remedy);
}

}  // namespace soms::detail
