/// \file
/// A page of the manual in the language of man (roff).
#pragma once

#include <string>
#include <vector>

namespace soms::command {

/// An option, an argument, a key or a verb, and what is said of it.
struct ManRow {
  std::vector<std::string> names;
  std::string value = {};  ///< what stands for its value; empty: it has none
  std::string text = {};
};

/// Rows under a heading.
struct ManList {
  std::string heading;
  std::vector<ManRow> rows = {};
};

/// A page of section 1.
struct ManPage {
  std::string name;     ///< as in the page's file name, without the section
  std::string version;  ///< of the program
  std::string summary;  ///< one line
  std::string command;  ///< of the synopsis, such as "soms ray"
  std::string words;    ///< behind it: "[OPTIONS] MODEL"
  std::vector<ManRow> arguments = {};
  std::vector<ManList> options = {};       ///< by heading
  std::string shared = {};                 ///< a paragraph below them; empty: none
  std::vector<ManList> lists = {};         ///< sections of their own: verbs, keys of a list
  std::string text = {};                   ///< paragraphs, lists and an example, as --help has them
  std::vector<std::string> see_also = {};  ///< names of other pages
};

[[nodiscard]] std::string roff(const ManPage& page);

}  // namespace soms::command
