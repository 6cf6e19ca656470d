#include "soms/io/detail/robot/urdf_values.h"

#include "soms/io/detail/text.h"
#include "soms/kinematics/robot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace soms::detail {

namespace {

constexpr const char* kRunXacro =
    "run xacro on it first, and give the URDF or SRDF file that it writes";

std::string attribute_name(pugi::xml_node element, const char* attribute) {
  return std::string(attribute) + " of " + named_element(element);
}

}  // namespace

std::string named_element(pugi::xml_node element) {
  std::string text = "<";
  text += element.name();
  if (const pugi::xml_attribute name = element.attribute("name")) {
    text += " name=" + in_quotes(name.value());
  }
  text += '>';
  return text;
}

std::string required_text(const XmlDocument& document, pugi::xml_node element,
                          const char* attribute) {
  const std::string text = element.attribute(attribute).value();
  if (text.empty()) {
    document.fail(element, named_element(element) + " has no " + attribute);
  }
  return text;
}

pugi::xml_node only_child(const XmlDocument& document, pugi::xml_node element, const char* name) {
  const pugi::xml_node child = element.child(name);
  if (const pugi::xml_node second = child.next_sibling(name)) {
    document.fail(second, named_element(element) + " has a second <" + name + ">",
                  "leave one of them");
  }
  return child;
}

pugi::xml_node required_child(const XmlDocument& document, pugi::xml_node element,
                              const char* name) {
  const pugi::xml_node child = only_child(document, element, name);
  if (!child) {
    document.fail(element, named_element(element) + " has no <" + name + ">");
  }
  return child;
}

void read_attribute(const XmlDocument& document, pugi::xml_node element, const char* attribute,
                    std::span<double> numbers) {
  const std::string_view whole = element.attribute(attribute).value();
  if (whole.find("${") != whole.npos || whole.find("$(") != whole.npos) {
    document.fail(
        element,
        attribute_name(element, attribute) + " is " + in_quotes(whole) + ", an expression of xacro",
        kRunXacro, ErrorKind::unsupported);
  }
  std::string_view rest = whole;
  std::size_t count = 0;
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
    if (rest.empty()) {
      break;
    }
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
    rest.remove_prefix(word.size());
    const char* const end = word.data() + word.size();
    const ParsedNumber parsed = parse_number(word.data(), end, Precision::as_double);
    if (parsed.status == NumberStatus::not_a_number || parsed.end != end) {
      document.fail(element, attribute_name(element, attribute) + " has " + in_quotes(word) +
                                 " instead of a number");
    }
    if (parsed.status == NumberStatus::too_large || !std::isfinite(parsed.value)) {
      document.fail(
          element,
          attribute_name(element, attribute) + " has " + in_quotes(word) + ", which is not finite",
          kRepairFile, ErrorKind::not_finite);
    }
    if (count < numbers.size()) {
      numbers[count] = parsed.value;
    }
    ++count;
  }
  if (count != numbers.size()) {
    document.fail(element, attribute_name(element, attribute) + " holds " + std::to_string(count) +
                               (count == 1 ? " number, not " : " numbers, not ") +
                               std::to_string(numbers.size()));
  }
}

double required_number(const XmlDocument& document, pugi::xml_node element, const char* attribute) {
  static_cast<void>(required_text(document, element, attribute));
  double number = 0;
  read_attribute(document, element, attribute, {&number, 1});
  return number;
}

double number_or(const XmlDocument& document, pugi::xml_node element, const char* attribute,
                 double missing) {
  return element.attribute(attribute) ? required_number(document, element, attribute) : missing;
}

Vec3 vector_or(const XmlDocument& document, pugi::xml_node element, const char* attribute,
               const Vec3& missing) {
  if (!element.attribute(attribute)) {
    return missing;
  }
  std::array<double, 3> numbers{};
  read_attribute(document, element, attribute, numbers);
  return {numbers[0], numbers[1], numbers[2]};
}

Pose read_origin(const XmlDocument& document, pugi::xml_node element) {
  const pugi::xml_node origin = only_child(document, element, "origin");
  const Vec3 xyz = vector_or(document, origin, "xyz", {});
  if (std::abs(xyz.x) > kMaxCoordinate || std::abs(xyz.y) > kMaxCoordinate ||
      std::abs(xyz.z) > kMaxCoordinate) {
    document.fail(origin, "xyz of " + named_element(origin) + " exceeds 2^300", kRepairFile,
                  ErrorKind::out_of_range);
  }
  return pose_from_rpy(vector_or(document, origin, "rpy", {}), xyz);
}

void refuse_macros(const XmlDocument& document) {
  constexpr std::string_view kMacro = "xacro:";
  for (pugi::xml_node node = document.root(); node;) {
    if (std::string_view(node.name()).starts_with(kMacro)) {
      document.fail(node, named_element(node) + " is a macro of xacro, which is not expanded",
                    kRunXacro, ErrorKind::unsupported);
    }
    if (node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node && node != document.root() && !node.next_sibling()) {
      node = node.parent();
    }
    node = !node || node == document.root() ? pugi::xml_node() : node.next_sibling();
  }
}

}  // namespace soms::detail
