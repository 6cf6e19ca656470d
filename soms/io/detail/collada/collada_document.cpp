#include "soms/io/detail/collada/collada_document.h"

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

/// Elements that others refer to by their ids.
constexpr std::array<std::string_view, 4> kReferred = {"controller", "geometry", "node",
                                                       "visual_scene"};

bool is_text(pugi::xml_node node) {
  return node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
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

std::string_view label_of(pugi::xml_node element) {
  const std::string_view name = element.attribute("name").value();
  return name.empty() ? element.attribute("id").value() : name;
}

ColladaDocument::ColladaDocument(Source& source) : XmlDocument(source, "COLLADA") {
  index_ids();
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

void ColladaDocument::tick(pugi::xml_node element) {
  reached_ = std::max(reached_, offset_of(element));
  source().tick(reached_);
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
