#include "apps/soms/verbs.h"
#include "apps/support/program.h"

int main(int argc, char** argv) {
  const soms::command::Program program{.name = "soms",
                                       .summary = "exact, fast answers to which triangles touch",
                                       .verbs = soms::command::verbs()};
  return soms::command::run_program(program, {argv + 1, argv + argc});
}
