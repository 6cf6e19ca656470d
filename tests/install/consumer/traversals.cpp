// A program that links the library of the named traversals. It ends with status 0 if they answer as
// the library does.
#include <soms/soms.h>
#include <soms/thesis/overlap.h>
#include <soms/thesis/traversals.h>

int main() {
  const soms::Mesh knot = soms::generate_knot(500);
  const soms::Body still{soms::Shape(knot, {.keep_tree = true})};
  const soms::Body moved(soms::Shape(knot, {.keep_tree = true}),
                         soms::Pose::translation(0.25, 0, 0));
  const soms::Overlap expected = soms::overlap(still, moved);
  for (const soms::TraversalEntry& entry : soms::traversals()) {
    if (soms::thesis::overlap(still, moved, {.traversal = entry.traversal}).answer.pairs !=
        expected.pairs) {
      return 1;
    }
  }
  return expected.pairs.empty() ? 1 : 0;
}
