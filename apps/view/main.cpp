#include "apps/cli/program.h"
#include "apps/view/verbs/verbs.h"

#include <string_view>

int main(int argc, char** argv) {
  // Started by the command it speaks as the command, whose verbs these are.
  const bool as_command = argc > 0 && std::string_view(argv[0]) == "soms";
  const soms::command::Program program{.name = as_command ? "soms" : "soms-view",
                                       .summary = "see what touches what, and why",
                                       .verbs = soms::view::verbs()};
  return soms::command::run_program(program, {argv + 1, argv + argc});
}
