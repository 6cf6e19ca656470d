/// \file
/// The elements of an XML document, with errors that name lines.
#pragma once

#include "soms/io/detail/source.h"

#include <cstddef>
#include <cstdint>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace soms::detail {

/// Remedy for most faults.
inline constexpr const char* kRepairFile = "repair the file, or export it again";

/// A parsed document.
class XmlDocument {
 public:
  /// Parses the source's bytes, whose root element must be `root_name`.
  /// \errors ErrorKind::bad_file (no well-formed XML, another root), unsupported (entities of its
  /// own), out_of_memory.
  XmlDocument(Source& source, std::string_view root_name);

  [[nodiscard]] Source& source() const { return source_; }

  [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }

  /// Takes memory from the budget. \errors ErrorKind::out_of_memory.
  void take(std::uint64_t bytes) const;

  /// "in line 7": where the element is.
  [[nodiscard]] std::string place_of(pugi::xml_node element) const;

  [[noreturn]] void fail(pugi::xml_node at, const std::string& what,
                         const std::string& remedy = kRepairFile,
                         ErrorKind kind = ErrorKind::bad_file) const;

 private:
  void parse();
  void refuse_entities() const;
  void refuse_zeros() const;

  Source& source_;
  pugi::xml_document document_;
};

/// Where the name of an element begins, or a text.
[[nodiscard]] std::size_t offset_of(pugi::xml_node node);

/// An element as messages call it: <geometry id="g">.
[[nodiscard]] std::string describe(pugi::xml_node element);

}  // namespace soms::detail
