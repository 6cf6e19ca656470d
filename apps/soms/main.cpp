#include "apps/soms/program.h"

int main(int argc, char** argv) {
  return soms::command::run_program({argv + 1, argv + argc});
}
