#include "apps/rows/answer_outputs.h"

#include "soms/base/error.h"

#include "apps/cli/parse.h"
#include "apps/cli/parser.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <vector>

namespace soms::command {

namespace {

constexpr const char* kOption = "-o";

/// What is written by -o to files of some extensions.
struct Kind {
  AnswerFile file;
  std::string AnswerOutputs::*name;
  std::vector<std::string_view> extensions;
  const char* meaning;   ///< in --help
  const char* old_name;  ///< nullptr: it has none
};

const std::array<Kind, 5>& all_kinds() {
  static const std::array<Kind, 5> kinds{
      Kind{AnswerFile::csv, &AnswerOutputs::csv, {".csv"}, ".csv", "--csv"},
      Kind{AnswerFile::npz, &AnswerOutputs::npz, {".npz"}, ".npz (NumPy)", "--binary"},
      Kind{AnswerFile::json, &AnswerOutputs::json, {".json"}, ".json", nullptr},
      Kind{AnswerFile::lines, &AnswerOutputs::lines, {".jsonl"}, ".jsonl (lines)", nullptr},
      Kind{
          AnswerFile::page, &AnswerOutputs::page, {".html", ".htm"}, ".html (a page)", "--report"}};
  return kinds;
}

std::vector<Kind> chosen(std::initializer_list<AnswerFile> wanted) {
  std::vector<Kind> kinds;
  std::copy_if(all_kinds().begin(), all_kinds().end(), std::back_inserter(kinds),
               [&](const Kind& kind) {
                 return std::find(wanted.begin(), wanted.end(), kind.file) != wanted.end();
               });
  return kinds;
}

/// Keeps the name of a file by its extension.
void name_output(AnswerOutputs& outputs, const std::vector<Kind>& kinds, const std::string& path) {
  const std::string extension = extension_of(path);
  std::vector<std::string_view> known;
  for (const Kind& kind : kinds) {
    const auto& own = kind.extensions;
    known.insert(known.end(), own.begin(), own.end());
    if (std::find(own.begin(), own.end(), extension) == own.end()) {
      continue;
    }
    std::string& name = outputs.*kind.name;
    if (!name.empty() && name != path) {
      throw Error(ErrorKind::usage,
                  fmt::format("{0} {1}: {0} {2} is given, too", kOption, path, name),
                  "give one file of each kind");
    }
    name = path;
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

}  // namespace

void add_answer_outputs(Parser& parser, AnswerOutputs& outputs,
                        std::initializer_list<AnswerFile> kinds, const char* heading) {
  const std::vector<Kind> own = chosen(kinds);
  std::vector<std::string> meanings;
  for (const Kind& kind : own) {
    meanings.emplace_back(kind.meaning);
  }
  parser
      .add_each_time(
          "-o,--output",
          [&outputs, own](const std::string& path) { name_output(outputs, own, path); },
          fmt::format("write the answers to a file, by its extension; may be repeated:\n{}",
                      fmt::join(meanings, ", ")))
      ->option_text("FILE")
      ->group(heading);
}

void add_renamed_outputs(Parser& parser, AnswerOutputs& outputs,
                         std::initializer_list<AnswerFile> kinds, const char* heading) {
  add_answer_outputs(parser, outputs, kinds, heading);
  for (const Kind& kind : chosen(kinds)) {
    if (kind.old_name != nullptr) {
      add_output(parser, kind.old_name, outputs.*kind.name, "")
          ->old_name_of(fmt::format("{} FILE{}", kOption, kind.extensions.front()))
          ->group(heading);
    }
  }
}

void check_answer_outputs(NamedFiles taken, const AnswerOutputs& outputs) {
  check_outputs(std::move(taken), {{kOption, outputs.csv},
                                   {kOption, outputs.npz},
                                   {kOption, outputs.json},
                                   {kOption, outputs.lines},
                                   {kOption, outputs.page}});
  check_extension(kOption, outputs.csv, {".csv"});
  check_extension(kOption, outputs.npz, {".npz"});
  check_extension(kOption, outputs.page, {".html", ".htm"});
}

}  // namespace soms::command
