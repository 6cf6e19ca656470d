/// \file
/// Options that change nothing beside the others: they are refused, never ignored.
#pragma once

#include <string>
#include <string_view>

namespace soms {

/// An option that has no effect, whatever its value, beside the other options that are set. Texts
/// are static; programs word them with their own names of the options.
struct IdleOption {
  std::string_view name;    ///< field of the options: "c_vertex"
  std::string_view reason;  ///< "only the midpoint `thesis` has a corner C"
  std::string_view needs;   ///< field that would give it an effect: "midpoint"
  std::string_view value;   ///< value that it would have to have; empty: another one

  [[nodiscard]] bool operator==(const IdleOption&) const = default;
};

/// Throws ErrorKind::usage about an idle option that is not at its default; `whose` begins the
/// message ("build options").
[[noreturn]] void refuse_idle(const std::string& whose, const IdleOption& idle);

}  // namespace soms
