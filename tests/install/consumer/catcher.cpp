// A program outside the project that lets soms fail and catches what it throws.
#include <soms/soms.h>

#include <iostream>

int main() {
  try {
    (void)soms::read_mesh("there is no such file.ply");
  } catch (const soms::Error& error) {
    std::cout << "caught " << soms::name(error.kind()) << '\n';
  }
}
