/// \file
/// Attributes and children of URDF and SRDF elements.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/io/detail/collada/xml_document.h"

#include <span>
#include <string>
#include <string_view>

namespace soms::detail {

/// An attribute that must be there and not empty. \errors ErrorKind::bad_file.
[[nodiscard]] std::string required_text(const XmlDocument& document, pugi::xml_node element,
                                        const char* attribute);

/// The child of this name, or nothing where there is none. \errors ErrorKind::bad_file for two.
[[nodiscard]] pugi::xml_node only_child(const XmlDocument& document, pugi::xml_node element,
                                        const char* name);

/// The same that must be there. \errors ErrorKind::bad_file.
[[nodiscard]] pugi::xml_node required_child(const XmlDocument& document, pugi::xml_node element,
                                            const char* name);

/// Reads an attribute that must be as many finite numbers as there is room, with blanks between.
/// \errors ErrorKind::bad_file, not_finite, unsupported (xacro).
void read_attribute(const XmlDocument& document, pugi::xml_node element, const char* attribute,
                    std::span<double> numbers);

/// One such number, which must be there. \errors As `read_attribute`.
[[nodiscard]] double required_number(const XmlDocument& document, pugi::xml_node element,
                                     const char* attribute);

/// The same, or `missing` where the attribute is. \errors As `read_attribute`.
[[nodiscard]] double number_or(const XmlDocument& document, pugi::xml_node element,
                               const char* attribute, double missing);

/// Three such numbers, or `missing` where the attribute or the element is.
/// \errors As `read_attribute`.
[[nodiscard]] Vec3 vector_or(const XmlDocument& document, pugi::xml_node element,
                             const char* attribute, const Vec3& missing);

/// The pose of the child `origin`; the identity where there is none. \errors As `read_attribute`.
[[nodiscard]] Pose read_origin(const XmlDocument& document, pugi::xml_node element);

/// Throws where an element or a number is one of xacro, which nobody has expanded.
/// \errors ErrorKind::unsupported.
void refuse_macros(const XmlDocument& document);

/// An element by its name: <joint name="elbow">.
[[nodiscard]] std::string named_element(pugi::xml_node element);

}  // namespace soms::detail
