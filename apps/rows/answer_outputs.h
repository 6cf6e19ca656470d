/// \file
/// The option -o of verbs that answer row by row: files whose extensions say what is written.
#pragma once

#include "apps/output/output.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

class Parser;

/// Files that answers go to, one of each kind; empty: none.
struct AnswerOutputs {
  std::string csv = {};    ///< a table
  std::string npz = {};    ///< columns, which NumPy loads
  std::string json = {};   ///< one document of all rows
  std::string lines = {};  ///< a row a line, as --json prints them
  std::string page = {};   ///< an HTML report

  [[nodiscard]] bool any() const {
    return !csv.empty() || !npz.empty() || !json.empty() || !lines.empty() || !page.empty();
  }
};

/// What -o writes to files of some extensions.
struct OutputKind {
  std::vector<std::string_view> extensions;
  std::string* name = nullptr;     ///< where the name of the file is kept
  const char* meaning = nullptr;   ///< in --help: ".html (a page)"
  const char* old_name = nullptr;  ///< an option of the last release; nullptr: it had none
};

/// Adds -o for files of these kinds, one of each, and their old names. `meaning` is what --help
/// says before the kinds.
/// \pre Where the names are kept outlives the parser.
void add_outputs(Parser& parser, const std::vector<OutputKind>& kinds, const char* heading,
                 const std::string& meaning);

/// \errors ErrorKind::usage as `check_outputs`, and for a name that came by an old name and has the
///         extension of another kind.
void check_outputs_by_extension(NamedFiles taken, const std::vector<OutputKind>& kinds,
                                const NamedFiles& others = {});

/// What -o of verbs that answer row by row can write.
enum class AnswerFile { csv, npz, json, lines, page };

/// Adds -o under a heading, for files of these kinds.
void add_answer_outputs(Parser& parser, AnswerOutputs& outputs,
                        std::initializer_list<AnswerFile> kinds, const char* heading);

/// The same, and its old names --csv, --binary and --report.
void add_renamed_outputs(Parser& parser, AnswerOutputs& outputs,
                         std::initializer_list<AnswerFile> kinds, const char* heading);

/// \errors ErrorKind::usage as `check_outputs`, and for an old name with another extension.
void check_answer_outputs(NamedFiles taken, const AnswerOutputs& outputs);

}  // namespace soms::command
