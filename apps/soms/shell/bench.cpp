#include "apps/soms/shell/bench.h"

#include "soms/base/error.h"

#include "apps/cli/child.h"
#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/model/models.h"

#include <memory>
#include <vector>

namespace soms::command {

std::filesystem::path bench_program() {
  return find_program(
      {.name = "soms-bench",
       .variable = "SOMS_BENCH",
       .remedy = "build it (cmake --preset bench && cmake --build --preset bench), or set "
                 "SOMS_BENCH to its path; see docs/bench.md"});
}

Action add_bench(Parser& parser, Shared&) {
  const auto options = std::make_shared<BenchOptions>();
  const char* const group = "Question";
  parser.add_option("A", options->a, "model that moves")->required();
  parser.add_option("B", options->b, "model that does not move")->required();
  Option* pose =
      parser
          .add_option("--pose", options->pose, "pose of A: \"x y z [qw qx qy qz]\", or a CSV file")
          ->option_text("POSE")
          ->group(group);
  add_count(parser, "--random", options->random, 1, 1'000'000,
            "number of random poses of A around B's box (default 1000)")
      ->excludes(pose)
      ->group(group);
  add_choice<std::string>(parser, "--ask", options->jobs,
                          {{"any", "any"},
                           {"all", "all"},
                           {"both", "any,all"},
                           {"distance", "distance"},
                           {"within", "within"}},
                          "what to time (both: any and all)")
      ->group(group);
  add_count(parser, "--rounds", options->rounds, 1, 1000,
            "timed rounds, in which libraries alternate (default 7)")
      ->group(group);
  add_output(parser, "-o,--output", options->out,
             "also write peers.csv and peers.md to this folder", "FOLDER")
      ->old_name("--out")
      ->group(group);
  add_strict(parser, options->strict);
  parser.footer(
      "Runs soms-bench, which times soms and every installed peer library on one thread pinned to\n"
      "one processor. Vertices are first rounded to floats, the same for all libraries. Answers\n"
      "are compared, too: if one is wrong, the ratio of the times is void.\n\nExample:\n"
      "  soms generate knot --triangles 2000 -o knot.ply\n"
      "  soms generate sphere --triangles 800 -o ball.off\n"
      "  soms bench knot.ply ball.off --random 100 --rounds 3");
  return [options](Console& console) { return run_bench(*options, console); };
}

int run_bench(const BenchOptions& options, Console& console) {
  if (options.a == "-" || options.b == "-") {
    throw Error(ErrorKind::usage, "bench cannot read a model from standard input",
                "give the model as a file");
  }
  const Shared& shared = console.shared();
  std::vector<std::string> words{as_argument(options.a), as_argument(options.b), "--jobs",
                                 options.jobs};
  const auto add = [&](const std::string& name, const std::string& value) {
    words.push_back(name);
    words.push_back(value);
  };
  add("--rounds", std::to_string(options.rounds));
  add("--seed", std::to_string(shared.seed));
  if (options.pose) {
    add("--pose", *options.pose);
  } else {
    add("--random", std::to_string(options.random));
  }
  if (!options.out.empty()) {
    add("--out", options.out);
  }
  if (options.strict) {
    words.emplace_back("--strict");
  }
  if (shared.json) {
    words.emplace_back("--json");
  }
  if (shared.quiet) {
    words.emplace_back("--quiet");
  }
  return run_child(bench_program(), words, console, {.called = "soms bench"});
}

}  // namespace soms::command
