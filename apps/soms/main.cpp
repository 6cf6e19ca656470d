#include "apps/soms/verbs.h"
#include "apps/support/program.h"

int main(int argc, char** argv) {
  return soms::command::run_program(soms::command::program(), {argv + 1, argv + argc});
}
