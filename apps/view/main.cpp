#include "apps/support/program.h"
#include "apps/view/verbs/verbs.h"

int main(int argc, char** argv) {
  const soms::command::Program program{.name = "soms-view",
                                       .summary = "see what touches what, and why",
                                       .verbs = soms::view::verbs()};
  return soms::command::run_program(program, {argv + 1, argv + argc});
}
