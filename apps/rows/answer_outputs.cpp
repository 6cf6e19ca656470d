#include "apps/rows/answer_outputs.h"

#include "soms/base/error.h"

#include "apps/cli/parse.h"
#include "apps/cli/parser.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace soms::command {

namespace {

constexpr const char* kOption = "-o";

constexpr const char* kAnswers =
    "write the answers to a file, by its extension; may be repeated:\n";

/// The kinds of a verb's answers, in their usual order.
std::vector<OutputKind> kinds_of(AnswerOutputs& outputs, std::initializer_list<AnswerFile> wanted) {
  const auto kind = [&](AnswerFile file) -> OutputKind {
    switch (file) {
      case AnswerFile::csv:
        return {{".csv"}, &outputs.csv, ".csv", "--csv"};
      case AnswerFile::npz:
        return {{".npz"}, &outputs.npz, ".npz (NumPy)", "--binary"};
      case AnswerFile::json:
        return {{".json"}, &outputs.json, ".json", nullptr};
      case AnswerFile::lines:
        return {{".jsonl"}, &outputs.lines, ".jsonl (lines)", nullptr};
      case AnswerFile::page:
        break;
    }
    return {{".html", ".htm"}, &outputs.page, ".html (a page)", "--report"};
  };
  std::vector<AnswerFile> files = wanted;
  std::sort(files.begin(), files.end());
  std::vector<OutputKind> kinds;
  for (const AnswerFile file : files) {
    kinds.push_back(kind(file));
  }
  return kinds;
}

/// Keeps the name of a file by its extension.
void name_output(const std::vector<OutputKind>& kinds, const std::string& path) {
  const std::string extension = extension_of(path);
  std::vector<std::string_view> known;
  for (const OutputKind& kind : kinds) {
    const auto& own = kind.extensions;
    known.insert(known.end(), own.begin(), own.end());
    if (std::find(own.begin(), own.end(), extension) == own.end()) {
      continue;
    }
    if (!kind.name->empty() && *kind.name != path) {
      throw Error(ErrorKind::usage,
                  fmt::format("{0} {1}: {0} {2} is given, too", kOption, path, *kind.name),
                  "give one file of each kind");
    }
    *kind.name = path;
    return;
  }
  if (path == "-") {
    throw Error(ErrorKind::usage,
                fmt::format("{} -: the answer is already written to standard output", kOption),
                "give the name of a file, or --json for answers as JSON");
  }
  throw Error(ErrorKind::usage, fmt::format("{} {}", kOption, path.empty() ? "\"\"" : path),
              fmt::format("use one of the extensions {}", fmt::join(known, ", ")));
}

void add_option_of_outputs(Parser& parser, const std::vector<OutputKind>& kinds,
                           const char* heading, const std::string& meaning) {
  std::vector<std::string> meanings;
  for (const OutputKind& kind : kinds) {
    meanings.emplace_back(kind.meaning);
  }
  parser
      .add_each_time(
          "-o,--output", [kinds](const std::string& path) { name_output(kinds, path); },
          fmt::format("{}{}", meaning, fmt::join(meanings, ", ")))
      ->option_text("FILE")
      ->group(heading);
}

}  // namespace

void add_outputs(Parser& parser, const std::vector<OutputKind>& kinds, const char* heading,
                 const std::string& meaning) {
  add_option_of_outputs(parser, kinds, heading, meaning);
  for (const OutputKind& kind : kinds) {
    if (kind.old_name != nullptr) {
      add_output(parser, kind.old_name, *kind.name, "")
          ->old_name_of(fmt::format("{} FILE{}", kOption, kind.extensions.front()))
          ->group(heading);
    }
  }
}

void check_outputs_by_extension(NamedFiles taken, const std::vector<OutputKind>& kinds,
                                const NamedFiles& others) {
  NamedFiles named = others;
  for (const OutputKind& kind : kinds) {
    named.emplace_back(kOption, *kind.name);
  }
  check_outputs(std::move(taken), named);
  for (const OutputKind& kind : kinds) {
    check_extension(kOption, *kind.name, kind.extensions);
  }
}

void add_answer_outputs(Parser& parser, AnswerOutputs& outputs,
                        std::initializer_list<AnswerFile> kinds, const char* heading) {
  add_option_of_outputs(parser, kinds_of(outputs, kinds), heading, kAnswers);
}

void add_renamed_outputs(Parser& parser, AnswerOutputs& outputs,
                         std::initializer_list<AnswerFile> kinds, const char* heading) {
  add_outputs(parser, kinds_of(outputs, kinds), heading, kAnswers);
}

void check_answer_outputs(NamedFiles taken, const AnswerOutputs& outputs) {
  AnswerOutputs named = outputs;
  check_outputs_by_extension(std::move(taken),
                             kinds_of(named, {AnswerFile::csv, AnswerFile::npz, AnswerFile::json,
                                              AnswerFile::lines, AnswerFile::page}));
}

}  // namespace soms::command
