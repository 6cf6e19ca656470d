/// \file
/// How text files are encoded: in ASCII or UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace soms {

/// Throws for a text in UTF-16, which its first two bytes show; `name` stands for the file.
/// \errors ErrorKind::unsupported.
void refuse_utf16(std::string_view bytes, const std::string& name);

}  // namespace soms
