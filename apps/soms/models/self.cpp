#include "apps/soms/models/self.h"

#include "soms/geometry/common_points.h"
#include "soms/query/reference/self_overlap.h"

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/cli/text.h"
#include "apps/model/part_filter.h"
#include "apps/model/shapes.h"
#include "apps/output/json.h"
#include "apps/rows/csv_file.h"
#include "apps/soms/pairs/pair_options.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

/// Most pairs that are listed as text.
constexpr std::size_t kListedPairs = 20;

/// What was found in a model, by the numbers of its file.
class SelfReport {
 public:
  SelfReport(const SelfVerbOptions& options, const ModelShape& model, SelfOverlap answer)
      : options_(&options), mesh_(model.file_mesh()), parts_(mesh_), answer_(std::move(answer)) {
    for (std::vector<TrianglePair>* pairs : {&answer_.pairs, &answer_.duplicates}) {
      for (TrianglePair& pair : *pairs) {
        pair = in_files(model.numbers, model.numbers, pair);
      }
    }
  }

  /// Cut before anything was found.
  [[nodiscard]] bool undecided() const { return !answer_.any && answer_.coverage == Coverage::cut; }

  [[nodiscard]] std::string text() const {
    std::string text = summary() + "\n" + listed(answer_.pairs);
    if (!answer_.duplicates.empty()) {
      text += fmt::format("{} of triangles {} the same corners\n",
                          counted(answer_.duplicates.size(), "pair"),
                          answer_.duplicates.size() == 1 ? "has" : "have") +
              listed(answer_.duplicates);
    }
    return text;
  }

  [[nodiscard]] Json json() const {
    Json json{{"schema", "soms.self/1"},
              {"file", options_->input},
              {"by", name(options_->question.by)},
              {"any", undecided() ? Json() : Json(answer_.any)}};
    json["coverage"] = name(answer_.coverage);
    json["cost"] = {{"node_tests", answer_.cost.node_tests},
                    {"triangle_tests", answer_.cost.triangle_tests},
                    {"exact_tests", answer_.cost.exact_tests}};
    json["pairs"] = pairs_json(answer_.pairs);
    json["duplicates"] = pairs_json(answer_.duplicates);
    return json;
  }

  void write_csv(const std::string& path) const {
    CsvFile file(path);
    file.line() = "kind,triangle_a,part_a,name_a,triangle_b,part_b,name_b,point_x,point_y,point_z";
    file.end_line();
    write_rows("overlap", answer_.pairs, file);
    write_rows("duplicate", answer_.duplicates, file);
    file.finish();
  }

 private:
  [[nodiscard]] std::string summary() const {
    const SelfOverlap& found = answer_;
    if (undecided()) {
      return "time ended before a pair was found";
    }
    if (!found.any) {
      return found.duplicates.empty() || found.coverage == Coverage::cut
                 ? "no triangles cross or touch beyond the corners that they share"
                 : "no other triangles cross or touch beyond the corners that they share";
    }
    return fmt::format("{}{} of triangles {} or {} beyond the corners that they share",
                       found.coverage == Coverage::complete ? "" : "at least ",
                       counted(found.pairs.size(), "pair"),
                       found.pairs.size() == 1 ? "crosses" : "cross",
                       found.pairs.size() == 1 ? "touches" : "touch");
  }

  [[nodiscard]] std::string listed(const std::vector<TrianglePair>& pairs) const {
    std::string text;
    for (std::size_t k = 0; k < std::min(kListedPairs, pairs.size()); ++k) {
      const Vec3 at = place_of(pairs[k]);
      text += fmt::format("  {} and {} at ({}, {}, {})\n", triangle_label(mesh_, pairs[k].a),
                          triangle_label(mesh_, pairs[k].b), readable(at.x), readable(at.y),
                          readable(at.z));
    }
    if (pairs.size() > kListedPairs) {
      text += fmt::format("  and {} more; --json or -o FILE lists all\n",
                          with_commas(pairs.size() - kListedPairs));
    }
    return text;
  }

  /// A common point, for people.
  [[nodiscard]] Vec3 place_of(const TrianglePair& pair) const {
    const CommonPoints common = common_points(mesh_.triangle(pair.a), mesh_.triangle(pair.b));
    Vec3 sum;
    for (const Vec3& point : common.points()) {
      sum += point * (1 / static_cast<double>(common.count));
    }
    return sum;
  }

  [[nodiscard]] Json pairs_json(const std::vector<TrianglePair>& pairs) const {
    Json rows = Json::array();
    for (const TrianglePair& pair : pairs) {
      const Vec3 at = place_of(pair);
      Json row{{"triangles", {pair.a, pair.b}}, {"point", {at.x, at.y, at.z}}};
      const std::uint32_t a = parts_(pair.a);
      const std::uint32_t b = parts_(pair.b);
      if (a != Part::kNoParent || b != Part::kNoParent) {
        row["parts"] = {part_named(mesh_, a), part_named(mesh_, b)};
      }
      rows.push_back(std::move(row));
    }
    return rows;
  }

  void write_rows(const char* kind, const std::vector<TrianglePair>& pairs, CsvFile& file) const {
    for (const TrianglePair& pair : pairs) {
      const Vec3 at = place_of(pair);
      file.line() += fmt::format("{},{},{},{},{},{},{},{}", kind, pair.a,
                                 part_csv_fields(mesh_, parts_(pair.a)), pair.b,
                                 part_csv_fields(mesh_, parts_(pair.b)), at.x, at.y, at.z);
      file.end_line();
    }
  }

  const SelfVerbOptions* options_;
  MeshView mesh_;
  PartsOf parts_;
  SelfOverlap answer_;
};

/// Compares with brute force; says what differs.
int verify(const SelfVerbOptions& options, const Shape& shape, const SelfOverlap& answer,
           Console& console) {
  const SelfOverlap truth = console.run("verifying", [&](const Limits& limits) {
    return reference::self_overlap(shape.mesh(), options.question.by, limits);
  });
  const bool whole = answer.coverage == Coverage::complete && truth.coverage == Coverage::complete;
  const bool all = options.question.mode == OverlapMode::all;
  const bool same = !whole || !all
                        ? std::includes(truth.pairs.begin(), truth.pairs.end(),
                                        answer.pairs.begin(), answer.pairs.end()) &&
                              (!whole || answer.any == truth.any)
                        : answer.pairs == truth.pairs && answer.duplicates == truth.duplicates;
  console.note(same
                   ? "brute force finds the same"
                   : fmt::format("brute force finds {} and {}", counted(truth.pairs.size(), "pair"),
                                 counted(truth.duplicates.size(), "duplicate")));
  return same ? 0 : kDifference;
}

void write_files(const SelfReport& report, const AnswerOutputs& outputs) {
  if (!outputs.csv.empty()) {
    report.write_csv(outputs.csv);
  }
  if (!outputs.json.empty()) {
    OutputFile file(outputs.json);
    file.stream() << json_line(report.json());
    file.commit();
  }
}

}  // namespace

Action add_self(Parser& parser, Shared&) {
  const auto options = std::make_shared<SelfVerbOptions>();
  parser.add_option("MODEL", options->input, "the model; - is standard input")->required();
  add_choice<CommonCorners>(
      parser, "--by", options->question.by,
      {{"index", CommonCorners::index}, {"position", CommonCorners::position}},
      "corners are shared by vertex, or by place (index)")
      ->group(kQuestionGroup);
  parser
      .add_flag_callback(
          "--any", [options] { options->question.mode = OverlapMode::any; },
          "stop at the first pair found, whichever it is")
      ->group(kQuestionGroup);
  add_choice<bool>(parser, "--fail-if", options->fail_if_overlap, {{"overlap", true}},
                   "exit with status 1 if triangles cross or touch beyond their corners")
      ->group(kQuestionGroup);
  add_answer_outputs(parser, options->outputs, {AnswerFile::csv, AnswerFile::json}, kQuestionGroup);
  parser
      .add_flag("--verify", options->verify,
                "compare with brute force; exit with status 6 if they differ")
      ->group(kQuestionGroup);
  add_model_options(parser, options->model, "--scale", "--up", "the model");
  add_city_options(parser, options->model, "", "the model");
  add_allow_empty(parser, options->model);
  add_part_filter(parser, options->model.parts, "the model");
  add_strict(parser, options->model.strict);
  add_tree_list(parser, options->build);
  parser.footer(
      "Neighbors share their corners, and may share nothing else. Files that repeat vertices, "
      "such\n"
      "as STL, need --by position. Triangles with the same corners are listed as duplicates.\n\n"
      "Example:\n"
      "  soms generate statue --triangles 5000 -o statue.ply\n"
      "  soms self statue.ply");
  return [options, &parser](Console& console) {
    check_build(parser, options->build);
    check_answer_outputs({}, options->outputs);
    return run_self(*options, console);
  };
}

int run_self(const SelfVerbOptions& options, Console& console) {
  const ModelShape model =
      load_only_model(options.input, options.model, {.build = options.build}, console);
  const SelfOverlap found = console.run(
      "looking for triangles that cross",
      [&](const Limits& limits) { return self_overlap(model.shape, options.question, limits); });
  const int difference = options.verify ? verify(options, model.shape, found, console) : 0;
  const SelfReport report(options, model, found);
  write_files(report, options.outputs);
  if (console.shared().json) {
    console.print(json_line(report.json()));
  } else {
    console.print(report.text());
  }
  if (difference != 0) {
    return difference;
  }
  if (options.fail_if_overlap && found.any) {
    return kConditionHolds;
  }
  return found.coverage == Coverage::cut && (options.fail_if_overlap || !found.any) ? kOutOfTime
                                                                                    : 0;
}

}  // namespace soms::command
