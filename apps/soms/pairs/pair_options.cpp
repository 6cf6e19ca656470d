#include "apps/soms/pairs/pair_options.h"

#include "soms/base/error.h"

#include "apps/cli/parser.h"
#include "apps/model/part_filter.h"

#include <algorithm>
#include <array>

namespace soms::command {

void add_posed_models(Parser& parser, PairOptions& options) {
  parser.add_option("A", options.a, "first model; - is standard input")->required();
  parser.add_option("B", options.b, "second model")->required();
  const std::string form =
      ": \"x y z [qw qx qy qz]\", CSV, .npy, .npz, row per pose; - is standard input";
  Option* const first = parser.add_option("--pose", options.pose_a, "pose of A" + form);
  first->option_text("POSE")->group(kQuestionGroup);
  parser.add_option("--pose-b", options.pose_b, "pose of B, in the same form")
      ->option_text("POSE")
      ->group(kQuestionGroup)
      ->shown_with(first, "pose of A or B" + form);
}

void add_verify(Parser& parser, PairOptions& options) {
  parser
      .add_flag("--verify", options.verify,
                "compare with brute force; exit with status 6 if they differ")
      ->group(kQuestionGroup);
}

void add_model_reading(Parser& parser, PairOptions& options) {
  add_model_options(parser, options.model_a, "--scale", "--up", "A");
  add_model_options(parser, options.model_b, "--scale-b", "--up-b", "B");
  parser.add_flag("--allow-empty", options.model_a.allow_empty, "accept models without triangles")
      ->group("Models");
  add_strict(parser, options.model_a.strict);
  add_part_filter(parser, options.model_a.parts, "A or B");
  options.model_a.parts->treat_unnamed(PartFilter::Unnamed::whole);
  add_tree_list(parser, options.build);
}

void settle(const Parser& parser, PairOptions& options) {
  options.model_a.offers_empty = true;
  options.model_b.offers_empty = true;
  options.model_b.allow_empty = options.model_a.allow_empty;
  options.model_b.strict = options.model_a.strict;
  options.model_b.parts = options.model_a.parts;
  check_build(parser, options.build);
}

std::string example_of_pair(const std::string& line) {
  return "\n\nExample:\n"
         "  soms generate knot --triangles 2000 -o knot.ply\n"
         "  soms generate sphere --triangles 800 -o ball.off\n"
         "  soms " +
         line;
}

void check_files(const PairOptions& options) {
  const std::array<std::optional<std::string>, 4> inputs{options.a, options.b, options.pose_a,
                                                         options.pose_b};
  if (std::count(inputs.begin(), inputs.end(), "-") > 1) {
    throw Error(ErrorKind::usage, "standard input is given twice", "give one of them as a file");
  }
  check_answer_outputs({{"A", options.a},
                        {"B", options.b},
                        {"--pose", options.pose_a.value_or("")},
                        {"--pose-b", options.pose_b.value_or("")}},
                       options.outputs);
}

}  // namespace soms::command
