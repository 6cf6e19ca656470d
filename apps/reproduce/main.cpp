#include "apps/reproduce/reproduce.h"
#include "apps/support/program.h"

#include <array>
#include <string_view>

int main(int argc, char** argv) {
  static constexpr std::array kVerbs{soms::command::Verb{
      "reproduce", "rerun the experiments of the thesis: tables, figures and a page",
      soms::command::add_reproduce}};
  // Started by the command it speaks as the command, whose verb this is.
  const bool as_command = argc > 0 && std::string_view(argv[0]) == "soms";
  const soms::command::Program program{.name = as_command ? "soms" : "soms-reproduce",
                                       .summary = "rerun the experiments of the thesis",
                                       .verbs = kVerbs};
  return soms::command::run_program(program, {argv + 1, argv + argc});
}
