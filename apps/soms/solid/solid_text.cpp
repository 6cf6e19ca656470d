#include "apps/soms/solid/solid_text.h"

#include <fmt/format.h>

namespace soms::command {

std::string_view relation_label(Relation relation) {
  return relation == Relation::a_in_b   ? "A in B"
         : relation == Relation::b_in_a ? "B in A"
                                        : name(relation);
}

bool shares_interior(Relation relation) {
  return relation == Relation::crossing || relation == Relation::a_in_b ||
         relation == Relation::b_in_a || relation == Relation::same;
}

std::string solid_in_words(const Solid& answer, std::string_view a, std::string_view b) {
  const char* const meet = answer.surfaces_meet ? "the surfaces meet" : "the surfaces do not meet";
  switch (answer.relation) {
    case Relation::clear:
      return "clear: nothing is shared";
    case Relation::touching:
      return "touching: surfaces meet, and no interior is shared";
    case Relation::crossing:
      return "crossing: interior is shared, and each has more of its own";
    case Relation::a_in_b:
      return fmt::format("A in B: {} is inside {}; {}", a, b, meet);
    case Relation::b_in_a:
      return fmt::format("B in A: {} is inside {}; {}", b, a, meet);
    case Relation::same:
      return "same: both fill the same space";
    case Relation::undecided:
      break;
  }
  return answer.why == Undecided::open
             ? "undecided: where this pose rounds its vertices, a model is not closed"
             : "undecided: out of time";
}

}  // namespace soms::command
