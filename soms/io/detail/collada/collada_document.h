/// \file
/// The elements of a COLLADA document: found by their ids, their text as numbers, errors that name
/// lines.
#pragma once

#include "soms/io/detail/collada/xml_document.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <pugixml.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

/// A document whose root is the element COLLADA.
class ColladaDocument : public XmlDocument {
 public:
  /// \errors As `XmlDocument`.
  explicit ColladaDocument(Source& source);

  /// Calls `use` for each element `name` of the whole document but those inside of <extra>.
  void for_each(std::string_view name, const std::function<void(pugi::xml_node)>& use) const;

  /// The element `name` that an attribute of `from` refers to.
  /// \errors ErrorKind::bad_file (no such attribute or element, an id given twice), unsupported (in
  /// another file).
  [[nodiscard]] pugi::xml_node referred(pugi::xml_node from, const char* attribute,
                                        std::string_view name) const;

  /// True if an attribute of `from` refers to elements `name` of this file.
  /// \errors ErrorKind::bad_file (no such attribute), unsupported (in another file).
  [[nodiscard]] bool refers_to(pugi::xml_node from, const char* attribute,
                               std::string_view name) const;

  /// The child of `parent` that an attribute of `from` refers to; children of any name count.
  /// \errors as of `referred`.
  [[nodiscard]] pugi::xml_node referred_child(pugi::xml_node from, const char* attribute,
                                              pugi::xml_node parent) const;

  /// A whole number in an attribute, or `missing` where the attribute is.
  /// \errors ErrorKind::bad_file.
  [[nodiscard]] std::uint64_t whole_number(pugi::xml_node element, const char* attribute,
                                           std::uint64_t missing) const;

  /// Reads the text of an element, which must be as many finite numbers as there is room.
  /// \errors ErrorKind::bad_file, not_finite.
  void read_numbers(pugi::xml_node element, std::span<double> numbers) const;

  /// Reports that reading has come to this element. \errors ErrorKind::cancelled.
  void tick(pugi::xml_node element);

 private:
  struct Identified {
    std::string_view name;
    std::string_view id;
    pugi::xml_node element;
  };

  void index_ids();
  [[nodiscard]] std::span<const Identified> find(std::string_view name, std::string_view id) const;
  [[nodiscard]] std::string_view fragment(pugi::xml_node from, const char* attribute) const;

  std::vector<Identified> ids_;  ///< sorted by name, then id
  std::size_t reached_ = 0;      ///< farthest byte that was reported
};

/// The words of an element's text. Comments may stand between them.
class ColladaTokens {
 public:
  /// \errors ErrorKind::bad_file: an element inside the element.
  ColladaTokens(const ColladaDocument& document, pugi::xml_node element);

  /// Most words that may be left.
  [[nodiscard]] std::size_t most_left() const;

  /// True if no word is left. \errors ErrorKind::bad_file: a comment inside a word.
  [[nodiscard]] bool at_end();

  /// The next number. \pre not at the end. \errors ErrorKind::bad_file, not_finite (too large).
  [[nodiscard]] double number();

  /// The next number, whole and not negative. \pre not at the end. \errors ErrorKind::bad_file.
  [[nodiscard]] std::uint64_t whole_number();

  [[noreturn]] void fail(ErrorKind kind, const std::string& what, const std::string& remedy) const;

 private:
  void enter(pugi::xml_node text);
  void end_token(const char* end, std::string_view expected);

  const ColladaDocument& document_;
  pugi::xml_node element_;
  pugi::xml_node text_;
  const char* begin_ = nullptr;
  const char* at_ = nullptr;
  const char* end_ = nullptr;
};

/// The name of an element, else its id, else nothing.
[[nodiscard]] std::string_view label_of(pugi::xml_node element);

}  // namespace soms::detail
