#include "apps/cli/program.h"
#include "thesis/program/reproduce.h"
#include "thesis/program/timing_process.h"

#include <array>
#include <span>
#include <string_view>

int main(int argc, char** argv) {
  static constexpr std::array kVerbs{soms::command::Verb{
      "reproduce", "rerun the experiments of the thesis: tables, figures and a page",
      soms::command::add_reproduce}};
  // What it starts itself with (thesis/program/timing_process.h).
  static constexpr std::array kOwnVerbs{soms::command::Verb{
      soms::command::kTimingVerb, "time races for a run", soms::command::add_timing_process}};
  const bool own = argc > 1 && std::string_view(argv[1]) == soms::command::kTimingVerb;
  // Started by the command it speaks as the command, whose verb this is.
  const bool as_command = argc > 0 && std::string_view(argv[0]) == "soms";
  const soms::command::Program program{
      .name = as_command ? "soms" : "soms-reproduce",
      .summary = "rerun the experiments of the thesis",
      .verbs = own ? std::span<const soms::command::Verb>(kOwnVerbs)
                   : std::span<const soms::command::Verb>(kVerbs)};
  return soms::command::run_program(program, {argv + 1, argv + argc});
}
