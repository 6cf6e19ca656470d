#include "soms/io/detail/collada_document.h"

#include "soms/io/detail/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <new>
#include <tuple>
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

/// Elements that others refer to by their ids.
constexpr std::array<std::string_view, 4> kReferred = {"controller", "geometry", "node",
                                                       "visual_scene"};

bool is_text(pugi::xml_node node) {
  return node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
}

std::size_t offset_of(pugi::xml_node node) {
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, node.offset_debug()));
}

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

/// The node behind another and what it holds in the order of the file, below `root`.
pugi::xml_node next_outside(pugi::xml_node node, pugi::xml_node root) {
  while (node != root && !node.next_sibling()) {
    node = node.parent();
  }
  return node == root ? pugi::xml_node() : node.next_sibling();
}

/// The node behind another in the order of the file, below `root`.
pugi::xml_node next_node(pugi::xml_node node, pugi::xml_node root) {
  return node.first_child() ? node.first_child() : next_outside(node, root);
}

}  // namespace

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

std::string_view label_of(pugi::xml_node element) {
  const std::string_view name = element.attribute("name").value();
  return name.empty() ? element.attribute("id").value() : name;
}

ColladaDocument::ColladaDocument(Source& source) : source_(source) {
  parse();
  refuse_entities();
  const pugi::xml_node last = document_.last_child();
  if (std::string_view(root().name()) != "COLLADA") {
    fail(root(), "the file begins with " + describe(root()) + ", not with <COLLADA>");
  }
  for (pugi::xml_node node = root(); node != last;) {
    node = node.next_sibling();
    if (node.type() == pugi::node_element) {
      fail(node, "a second root element, " + describe(node) + ", follows the first");
    }
  }
  refuse_zeros();
  index_ids();
}

/// pugixml takes no limit, so what it may need is taken before: a text, and at most one element
/// and one text for each <, one attribute for each =.
void ColladaDocument::parse() {
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
void ColladaDocument::refuse_entities() const {
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
void ColladaDocument::refuse_zeros() const {
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

void ColladaDocument::index_ids() {
  const auto for_each_id = [&](const auto& use) {
    for (pugi::xml_node node = root(); node; node = next_node(node, root())) {
      const auto* name = std::find(kReferred.begin(), kReferred.end(), node.name());
      const pugi::xml_attribute id = node.attribute("id");
      if (name != kReferred.end() && id) {
        use(Identified{*name, id.value(), node});
      }
    }
  };
  std::size_t count = 0;
  for_each_id([&](const Identified&) { ++count; });
  take(count * sizeof(Identified));
  ids_.reserve(count);
  for_each_id([&](const Identified& identified) { ids_.push_back(identified); });
  std::sort(ids_.begin(), ids_.end(), [](const Identified& a, const Identified& b) {
    return std::tie(a.name, a.id) < std::tie(b.name, b.id);
  });
}

void ColladaDocument::for_each(std::string_view name,
                               const std::function<void(pugi::xml_node)>& use) const {
  for (pugi::xml_node node = root(); node;) {
    const std::string_view found = node.name();
    if (found == name) {
      use(node);
    }
    node = found == "extra" ? next_outside(node, root()) : next_node(node, root());
  }
}

std::string_view ColladaDocument::fragment(pugi::xml_node from, const char* attribute) const {
  const pugi::xml_attribute url = from.attribute(attribute);
  if (!url) {
    fail(from, describe(from) + " has no " + attribute);
  }
  const std::string_view value = url.value();
  if (!value.starts_with('#')) {
    fail(from,
         describe(from) + " refers to " + in_quotes(value) +
             ", which is not in this file; other files are not opened",
         "export the model into one file", ErrorKind::unsupported);
  }
  return value.substr(1);
}

auto ColladaDocument::find(std::string_view name, std::string_view id) const
    -> std::span<const Identified> {
  const auto [begin, end] =
      std::equal_range(ids_.begin(), ids_.end(), Identified{name, id, {}},
                       [](const Identified& a, const Identified& b) {
                         return std::tie(a.name, a.id) < std::tie(b.name, b.id);
                       });
  return {begin, end};
}

bool ColladaDocument::refers_to(pugi::xml_node from, const char* attribute,
                                std::string_view name) const {
  return !find(name, fragment(from, attribute)).empty();
}

pugi::xml_node ColladaDocument::referred(pugi::xml_node from, const char* attribute,
                                         std::string_view name) const {
  const std::string_view id = fragment(from, attribute);
  const std::span<const Identified> found = find(name, id);
  if (found.empty()) {
    fail(from, describe(from) + " refers to " + std::string(name) + " " + in_quotes(id) +
                   ", which does not exist");
  }
  if (found.size() > 1) {
    fail(from, describe(from) + " refers to " + std::string(name) + " " + in_quotes(id) +
                   ", which is defined twice");
  }
  return found.front().element;
}

pugi::xml_node ColladaDocument::referred_child(pugi::xml_node from, const char* attribute,
                                               pugi::xml_node parent) const {
  const std::string_view id = fragment(from, attribute);
  pugi::xml_node found;
  for (const pugi::xml_node child : parent.children()) {
    if (child.attribute("id") && child.attribute("id").value() == id) {
      if (found) {
        fail(child, "id " + in_quotes(id) + " occurs twice in " + describe(parent));
      }
      found = child;
    }
  }
  if (!found) {
    fail(from, describe(from) + " refers to " + in_quotes(id) + ", which does not exist in " +
                   describe(parent));
  }
  return found;
}

std::uint64_t ColladaDocument::whole_number(pugi::xml_node element, const char* attribute,
                                            std::uint64_t missing) const {
  const pugi::xml_attribute found = element.attribute(attribute);
  if (!found) {
    return missing;
  }
  const std::string_view text = found.value();
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size()) {
    fail(element, std::string(attribute) + " of " + describe(element) + " is " + in_quotes(text) +
                      ", not a whole number from 0 to 2^64 - 1");
  }
  return value;
}

void ColladaDocument::read_numbers(pugi::xml_node element, std::span<double> numbers) const {
  ColladaTokens tokens(*this, element);
  std::size_t count = 0;
  for (; !tokens.at_end(); ++count) {
    const double value = tokens.number();
    if (!std::isfinite(value)) {
      tokens.fail(ErrorKind::not_finite, "a number of " + describe(element) + " is not finite",
                  kRepairFile);
    }
    if (count < numbers.size()) {
      numbers[count] = value;
    }
  }
  if (count != numbers.size()) {
    fail(element, describe(element) + " holds " + std::to_string(count) + " numbers, not " +
                      std::to_string(numbers.size()));
  }
}

void ColladaDocument::take(std::uint64_t bytes) const {
  if (!source_.budget.take(bytes)) {
    source_.fail_memory(bytes);
  }
}

void ColladaDocument::tick(pugi::xml_node element) {
  reached_ = std::max(reached_, offset_of(element));
  source_.tick(reached_);
}

std::string ColladaDocument::place_of(pugi::xml_node element) const {
  return "in " + source_.line_of(offset_of(element));
}

void ColladaDocument::fail(pugi::xml_node at, const std::string& what, const std::string& remedy,
                           ErrorKind kind) const {
  source_.fail_line(offset_of(at), kind, what, remedy);
}

ColladaTokens::ColladaTokens(const ColladaDocument& document, pugi::xml_node element)
    : document_(document), element_(element) {
  for (const pugi::xml_node child : element.children()) {
    if (!is_text(child)) {
      document.fail(child, describe(child) + " stands among the numbers of " + describe(element));
    }
  }
  enter(element.first_child());
}

void ColladaTokens::enter(pugi::xml_node text) {
  text_ = text;
  begin_ = text.value();
  at_ = begin_;
  end_ = begin_ + std::strlen(begin_);
}

std::size_t ColladaTokens::most_left() const {
  std::size_t bytes = static_cast<std::size_t>(end_ - at_) + 1;
  for (pugi::xml_node next = text_.next_sibling(); next; next = next.next_sibling()) {
    bytes += std::strlen(next.value()) + 1;
  }
  return bytes / 2;
}

bool ColladaTokens::at_end() {
  while (true) {
    while (at_ != end_ && is_space(*at_)) {
      ++at_;
    }
    if (at_ != end_) {
      return false;
    }
    const pugi::xml_node next = text_.next_sibling();
    if (!next) {
      return true;
    }
    // XML joins what a comment or the edge of a CDATA section parts: "1<!-- -->2" is 12.
    const bool parted = begin_ == end_ || is_space(end_[-1]) || is_space(*next.value());
    enter(next);
    if (!parted) {
      fail(ErrorKind::bad_file, "a comment or CDATA interrupts a number", kRepairFile);
    }
  }
}

void ColladaTokens::end_token(const char* end, std::string_view expected) {
  if (end == nullptr || (end != end_ && !is_space(*end))) {
    const char* stop = std::find_if(at_, end_, is_space);
    fail(ErrorKind::bad_file,
         describe(element_) + " has " + in_quotes({at_, static_cast<std::size_t>(stop - at_)}) +
             " instead of " + std::string(expected),
         kRepairFile);
  }
  at_ = end;
}

double ColladaTokens::number() {
  const ParsedNumber parsed = parse_number(at_, end_, Precision::as_double);
  if (parsed.status == NumberStatus::too_large) {
    fail(ErrorKind::not_finite, "a number of " + describe(element_) + " is too large for a double",
         "repair or scale the model");
  }
  end_token(parsed.status == NumberStatus::good ? parsed.end : nullptr, "a number");
  return parsed.value;
}

std::uint64_t ColladaTokens::whole_number() {
  std::uint64_t value = 0;
  const char* begin = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
  const auto [stop, error] = std::from_chars(begin, end_, value);
  end_token(error == std::errc() ? stop : nullptr, "a whole number from 0 to 2^64 - 1");
  return value;
}

void ColladaTokens::fail(ErrorKind kind, const std::string& what, const std::string& remedy) const {
  const std::size_t inside = static_cast<std::size_t>(at_ - begin_);
  const std::size_t text = text_ ? offset_of(text_) : offset_of(element_);
  document_.source().fail_line(text + inside, kind, what, remedy);
}

}  // namespace soms::detail
