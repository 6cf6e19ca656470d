#include "apps/cli/verb_data.h"

#include "apps/output/json.h"

#include <algorithm>
#include <utility>

namespace soms::command {

namespace {

constexpr const char* kSchema = "soms.verb/1";

/// The lines of a meaning as one. A list of words is broken behind a bar.
std::string one_line(std::string_view meaning) {
  std::string line;
  for (const char c : meaning) {
    if (c != '\n') {
      line += c;
    } else if (!line.ends_with('|')) {
      line += ' ';
    }
  }
  return line;
}

/// "; not with --all, --by or --limit", as --help says it. An option excludes what excludes it.
std::string excluded(const Parser& parser, const Option& option) {
  std::vector<std::string> others;
  const auto excludes = [](const Option& one, const Option& other) {
    return std::find(one.excluded().begin(), one.excluded().end(), &other) != one.excluded().end();
  };
  for (const Option* const other : parser.options()) {
    if (excludes(option, *other) || excludes(*other, option)) {
      others.push_back(other->name());
    }
  }
  std::sort(others.begin(), others.end());
  std::string text;
  for (std::size_t i = 0; i < others.size(); ++i) {
    text += (i == 0 ? "; not with " : i + 1 == others.size() ? " or " : ", ") + others[i];
  }
  return text;
}

OptionData option_data(const Parser& parser, const Option& option) {
  OptionData data{
      .names = option.dashed_names(),
      .value = option.has_value() ? option.option_text() : std::string(),
      .meaning = parser.with_keys(one_line(option.shown_meaning()) + excluded(parser, option)),
      .choices = option.choices(),
      .group = option.group(),
      .list = option.list() == nullptr ? std::string() : option.list()->name(),
      .is_argument = option.is_argument(),
      .is_required = option.is_required(),
      .takes_several = option.takes() == Takes::several};
  if (data.is_argument) {
    data.names = {option.names()};
  }
  for (const Option::OldName& old : option.old_names()) {
    data.old_names.push_back(old.name);
  }
  return data;
}

/// Without old names.
std::vector<const Option*> options_of(const Parser& parser) {
  std::vector<const Option*> options = parser.options();
  std::erase_if(options, [](const Option* option) { return option->is_old_name(); });
  return options;
}

/// Short names first; those of options of a second model on the line of the first.
void add_lines(const Parser& parser, std::vector<OptionData>& options) {
  const std::vector<const Option*> all = options_of(parser);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Option* const on = all[k]->shown_on() == nullptr ? all[k] : all[k]->shown_on();
    const auto at = std::find(all.begin(), all.end(), on) - all.begin();
    std::vector<std::string>& line = options[static_cast<std::size_t>(at)].line;
    line.insert(line.end(), options[k].names.rbegin(), options[k].names.rend());
  }
}

std::string text_of(const Json& json, const char* key) {
  return json.at(key).get<std::string>();
}

std::vector<std::string> texts_of(const Json& json, const char* key) {
  std::vector<std::string> texts;
  for (const Json& text : json.at(key)) {
    texts.push_back(text.get<std::string>());
  }
  return texts;
}

}  // namespace

VerbData data_of(const Parser& parser) {
  VerbData data{.name = parser.name(),
                .question = parser.question(),
                .footer = parser.with_keys(parser.footer())};
  for (const Option* const option : options_of(parser)) {
    data.options.push_back(option_data(parser, *option));
  }
  add_lines(parser, data.options);
  return data;
}

std::string data_as_json(const VerbData& data) {
  Json options = Json::array();
  for (const OptionData& option : data.options) {
    options.push_back({{"names", option.names},
                       {"line", option.line},
                       {"value", option.value},
                       {"meaning", option.meaning},
                       {"choices", option.choices},
                       {"old_names", option.old_names},
                       {"group", option.group},
                       {"list", option.list},
                       {"is_argument", option.is_argument},
                       {"is_required", option.is_required},
                       {"takes_several", option.takes_several}});
  }
  return json_line({{"schema", kSchema},
                    {"name", data.name},
                    {"question", data.question},
                    {"footer", data.footer},
                    {"options", std::move(options)}});
}

std::optional<VerbData> data_from_json(std::string_view text) {
  constexpr int kDeepest = 4;
  const Json json = parse_json(text, kDeepest).value;
  try {
    if (text_of(json, "schema") != kSchema) {
      return std::nullopt;
    }
    VerbData data{.name = text_of(json, "name"),
                  .question = text_of(json, "question"),
                  .footer = text_of(json, "footer")};
    for (const Json& option : json.at("options")) {
      data.options.push_back({.names = texts_of(option, "names"),
                              .line = texts_of(option, "line"),
                              .value = text_of(option, "value"),
                              .meaning = text_of(option, "meaning"),
                              .choices = texts_of(option, "choices"),
                              .old_names = texts_of(option, "old_names"),
                              .group = text_of(option, "group"),
                              .list = text_of(option, "list"),
                              .is_argument = option.at("is_argument").get<bool>(),
                              .is_required = option.at("is_required").get<bool>(),
                              .takes_several = option.at("takes_several").get<bool>()});
      if (data.options.back().names.empty()) {
        return std::nullopt;
      }
    }
    return data;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace soms::command
