/// \file
/// From the text of --help to a page of the manual.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// A page of section 1.
struct ManPage {
  std::string name;                   ///< as in the page's file name, without the section
  std::string version;                ///< of the program
  std::string_view help;              ///< the text of --help
  std::vector<std::string> see_also;  ///< names of other pages
};

/// The page in the language of man (roff). All of the help's text is in it: its first line as the
/// page's name, "Usage:" as the synopsis, blocks under headings as sections, the rest as the
/// description.
[[nodiscard]] std::string roff(const ManPage& page);

}  // namespace soms::command
