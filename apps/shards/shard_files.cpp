#include "apps/shards/shard_files.h"

#include "soms/base/error.h"
#include "soms/base/text.h"
#include "soms/tree/print.h"

#include "apps/cli/console.h"
#include "apps/cli/parser.h"
#include "apps/model/models.h"
#include "apps/model/part_filter.h"
#include "apps/output/output.h"
#include "apps/shards/receipt.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <system_error>
#include <tuple>
#include <utility>

namespace soms::command {

namespace {

constexpr const char* kOption = "--shard";
constexpr const char* kCsv = ".csv";
constexpr const char* kNpz = ".npz";

std::optional<std::uint64_t> count(const std::string& option,
                                   const std::optional<std::string>& text, const Console& console) {
  return text ? count_poses(option, *text, console) : std::nullopt;
}

/// DIR/shard of DIR/shard.npz. An old name of -o names the folder alone.
std::filesystem::path name_of(const std::string& path, const char* extension) {
  return extension_of(path) == extension ? std::filesystem::path(path).replace_extension()
                                         : std::filesystem::path(path) / "shard";
}

/// What the names of the files of all shards begin with; makes their folder.
/// \errors ErrorKind::usage.
std::filesystem::path common_name(const AnswerOutputs& outputs, const Shard& shard) {
  if (outputs.csv.empty() && outputs.npz.empty()) {
    throw Error(ErrorKind::usage,
                fmt::format("{} {}: nothing says where its answers go", kOption, shard.text()),
                "also give -o DIR/shard.npz or -o DIR/shard.csv, in the folder of all shards");
  }
  const std::filesystem::path name =
      outputs.npz.empty() ? name_of(outputs.csv, kCsv) : name_of(outputs.npz, kNpz);
  if (!outputs.csv.empty() && !outputs.npz.empty() && name_of(outputs.csv, kCsv) != name) {
    throw Error(ErrorKind::usage,
                fmt::format("{} with {} and {}", kOption, outputs.csv, outputs.npz),
                "give both the same folder and name");
  }
  const std::filesystem::path folder = name.parent_path();
  std::error_code failed;
  if (!folder.empty() && !std::filesystem::is_directory(folder, failed)) {
    std::filesystem::create_directories(folder, failed);
    if (failed) {
      throw Error(ErrorKind::cannot_write,
                  fmt::format("{}: cannot be made a folder: {}", folder.string(), failed.message()),
                  "give the folder of all shards");
    }
  }
  return name;
}

/// A share is one of several runs, of which some may find their answers there.
void refuse_others(const PosedModels& options, bool has_condition) {
  const AnswerOutputs& outputs = options.outputs;
  for (const auto& [given, name] : {std::pair(options.verify, std::string("--verify")),
                                    std::pair(has_condition, std::string("--fail-if")),
                                    std::pair(!outputs.page.empty(), "-o " + outputs.page),
                                    std::pair(!outputs.json.empty(), "-o " + outputs.json),
                                    std::pair(!outputs.lines.empty(), "-o " + outputs.lines)}) {
    if (given) {
      throw Error(ErrorKind::usage, fmt::format("{} does not go with {}", name, kOption),
                  "leave one of them out");
    }
  }
  const std::array<std::string, 4> inputs{options.a, options.b, options.pose_a.value_or(""),
                                          options.pose_b.value_or("")};
  if (std::find(inputs.begin(), inputs.end(), "-") != inputs.end()) {
    throw Error(ErrorKind::usage, std::string(kOption) + ": standard input is read by one program",
                "give files, which the program of each shard reads");
  }
}

/// What identifies a model, or a folder of tiles.
Json entry_of(const std::string& path, const ModelOptions& model, const Console& console) {
  return is_tile_folder(path) ? model_entry(TileSet::open(path))
                              : model_entry(read_model(path, model, console));
}

}  // namespace

ShardFiles::ShardFiles(const PosedModels& options, Json question, AnswerOutputs& outputs,
                       const Console& console)
    : shard_(options.shard.value()),
      question_(std::move(question)),
      csv_(!outputs.csv.empty()),
      npz_(!outputs.npz.empty()) {
  if (options.build != BuildOptions()) {
    std::ostringstream tree;
    tree << options.build;
    question_["tree"] = tree.str();
  }
  if (options.model_a.parts && options.model_a.parts->is_given()) {
    question_["parts"] = options.model_a.parts->text();
  }
  rows_a_ = count("--pose", options.pose_a, console);
  rows_b_ = count("--pose-b", options.pose_b, console);
  if (!rows_a_ && !rows_b_) {
    throw Error(ErrorKind::usage, fmt::format("{} {}: there is one pose", kOption, shard_.text()),
                "give --pose a file of several");
  }
  if (rows_a_ && rows_b_ && *rows_a_ != *rows_b_) {
    throw Error(ErrorKind::bad_file,
                fmt::format("{} has {} poses, {} has {}", *options.pose_a, *rows_a_,
                            *options.pose_b, *rows_b_),
                "give the same number of poses in both, or a single pose for one of them");
  }
  of_ = rows_a_ ? *rows_a_ : *rows_b_;
  rows_ = shard_.rows_of(of_);
  poses_ = {{"a", poses_entry(options.pose_a, rows_a_)},
            {"b", poses_entry(options.pose_b, rows_b_)}};
  stem_ = common_name(outputs, shard_);
  stem_ += fmt::format("-{}", shard_.number);
  for (const auto& [wanted, name, kind] :
       {std::tuple(csv_, &outputs.csv, kCsv), std::tuple(npz_, &outputs.npz, kNpz)}) {
    if (wanted) {
      *name = stem_.string() + kind;
    }
  }
}

Json ShardFiles::receipt(const Json& a, const Json& b) const {
  return {{"schema", kShardSchema},
          {"version", SOMS_VERSION},
          {"question", question_},
          {"models", {{"a", a}, {"b", b}}},
          {"poses", poses_},
          {"of", of_},
          {"rows", Json::array({rows_.begin, rows_.end})}};
}

bool ShardFiles::are_there(const PosedModels& options, const Console& console) const {
  const std::string path = stem_.string() + ".json";
  std::error_code missing;
  if (!std::filesystem::exists(path, missing)) {
    return false;
  }
  const Receipt there = read_receipt(path);
  const Json wanted = receipt(entry_of(options.a, options.model_a, console),
                              entry_of(options.b, options.model_b, console));
  const bool same_rows = there.value["rows"] == wanted["rows"];
  if (const auto other =
          same_rows ? difference(there.value, wanted) : std::optional<std::string>("rows")) {
    throw Error(ErrorKind::bad_file,
                fmt::format("{}: is of another run: its {} differs", path, *other),
                "give another folder, or remove what is in this one");
  }
  if ((csv_ && !there.is_whole("csv")) || (npz_ && !there.is_whole("npz"))) {
    return false;
  }
  console.note(fmt::format("{}: is there and whole", printable(path)));
  return true;
}

PosePairs ShardFiles::poses(const PosedModels& options, const Console& console) const {
  const auto source = [&](const std::string& option, const std::optional<std::string>& text,
                          const std::optional<std::uint64_t>& rows) {
    return rows   ? PoseSource(option, *text, console, rows_)
           : text ? PoseSource(option, *text, console, NoRows::no_poses)
                  : PoseSource();
  };
  return {source("--pose", options.pose_a, rows_a_), source("--pose-b", options.pose_b, rows_b_),
          rows_.size()};
}

void ShardFiles::finish(const Json& a, const Json& b, const Console& console) const {
  Json files = Json::object();
  for (const auto& [written, kind] : {std::pair(csv_, "csv"), std::pair(npz_, "npz")}) {
    if (written) {
      const std::string path = fmt::format("{}.{}", stem_.string(), kind);
      make_durable(path);
      files[kind] = file_entry(path);
    }
  }
  Json whole = receipt(a, b);
  whole["files"] = std::move(files);
  const std::string path = stem_.string() + ".json";
  OutputFile out(path);
  out.stream() << json_line(whole);
  out.sync();
  out.commit();
  make_durable(stem_.parent_path());
  console.note(
      fmt::format("{}: rows {} to {} of {}", printable(path), rows_.begin, rows_.end, of_));
}

bool begin_shard(PosedModels& options, Json question, bool has_condition, const Console& console) {
  if (!options.shard) {
    return true;
  }
  refuse_others(options, has_condition);
  const auto files =
      std::make_shared<ShardFiles>(options, std::move(question), options.outputs, console);
  options.files = files;
  return !files->are_there(options, console);
}

void add_shard(Parser& parser, PosedModels& options, const char* heading) {
  parser
      .add_option_function(
          kOption,
          [&options](const std::string& word) { options.shard = parse_shard(kOption, word); },
          "answer share K of N of the rows; its number goes behind the names of -o")
      ->option_text("K/N")
      ->group(heading);
}

}  // namespace soms::command
