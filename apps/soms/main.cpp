#include "apps/cli/program.h"
#include "apps/soms/shell/verbs.h"

int main(int argc, char** argv) {
  return soms::command::run_program(soms::command::program(), {argv + 1, argv + argc});
}
