/// \file
/// A verb as data: what man pages and completion are made of, also of verbs of other programs,
/// which print it as JSON.
#pragma once

#include "apps/cli/parser.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// The word that, alone behind a verb, prints its data. --help does not list it: it is between
/// programs of one version.
inline constexpr std::string_view kDataWord = "--verb-as-json";

/// An option or an argument.
struct OptionData {
  std::vector<std::string> names = {};      ///< with their dashes, long ones first; or the argument
  std::vector<std::string> line = {};       ///< names on its line of --help; none: on another's
  std::string value = {};                   ///< what stands for its value; empty: it has none
  std::string meaning = {};                 ///< one paragraph
  std::vector<std::string> choices = {};    ///< words of which the value is one; empty: anything
  std::vector<std::string> old_names = {};  ///< of earlier releases, which still work
  std::string group = {};                   ///< heading
  std::string list = {};                    ///< the list that it is a key of: "--tree"
  bool is_argument = false;
  bool is_required = false;
  bool takes_several = false;

  [[nodiscard]] bool operator==(const OptionData&) const = default;
};

/// A verb with its options, in the order of --help.
struct VerbData {
  std::string name = {};      ///< as in usage lines: "soms ray"
  std::string question = {};  ///< the first line of the help
  std::string footer = {};    ///< the text below the options
  std::vector<OptionData> options = {};

  [[nodiscard]] bool operator==(const VerbData&) const = default;
};

[[nodiscard]] VerbData data_of(const Parser& parser);

/// As text of JSON, on one line.
[[nodiscard]] std::string data_as_json(const VerbData& data);

/// What `data_as_json` wrote; nothing if the text is something else.
[[nodiscard]] std::optional<VerbData> data_from_json(std::string_view text);

}  // namespace soms::command
