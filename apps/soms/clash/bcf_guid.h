/// \file
/// The names of things in BCF archives: GUIDs that the same clash always gets, and those of IFC.
#pragma once

#include <string>
#include <string_view>

namespace soms::command {

/// The GUID of what has this name in our archives, in lower case: a UUID of version 5.
/// \source RFC 9562, section 5.5.
[[nodiscard]] std::string bcf_guid(std::string_view name);

/// True if `id` can be the GlobalId of an IFC file: 128 bits as 22 digits to base 64, of which the
/// first is at most 3.
[[nodiscard]] bool is_ifc_guid(std::string_view id);

}  // namespace soms::command
