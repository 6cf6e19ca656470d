// A program that needs the core alone: no files, no facade.
#include "soms/query/overlap.h"

#include <cstdio>

int main() {
  const soms::Shape shape(
      soms::Mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}});
  const bool any = overlap(soms::Body(shape), soms::Body(shape)).any;
  std::puts(any ? "touches" : "free");
  return any ? 0 : 1;
}
