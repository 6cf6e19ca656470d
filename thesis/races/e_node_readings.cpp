#include "thesis/races/e_node_readings.h"

#include <array>
#include <string>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr TraversalOptions e_node(Descent descent) {
  return {.traversal = Traversal::e_node, .descent = descent};
}

constexpr TraversalOptions from_front(Descent descent) {
  return {.traversal = Traversal::e_node_front, .descent = descent};
}

constexpr std::string_view kFrontFor =
    "Heading 5.5: \"Earlier\" as in the frame before; scope 5 has a moving object, frame by frame.";
constexpr std::string_view kFrontAgainst =
    "Section 1.7: \"embedded with the new Splitting Rules\", so what is new lies in the tree; no "
    "caption has a frame before, or a memory.";

constexpr std::array kReadings{
    EnodeReading{
        .name = "family_both",
        .title = "tests children before it enters them, both nodes",
        .speaks_for =
            "Heading 5.5: \"Earlier Node detection\"; figure 2.16, caption: \"visiting only nodes "
            "that is confirmed to be intersected with the other nodes\"; figure 5.10 compares it "
            "with Larsson's traversal, which descends both nodes as we take it.",
        .speaks_against = "Abstract: \"specially designed to perform traversal testing for SOMS "
                          "technique\", and it takes any tree. Nothing else.",
        .stands = "taken",
        .options = e_node(Descent::both)},
    EnodeReading{.name = "family_larger",
                 .title = "the same, larger node",
                 .speaks_for =
                     "Figure 4.37, caption: \"Ericson Generic Traversal\", which descends "
                     "the larger node in his book.",
                 .speaks_against = "Figure 5.10, caption: \"comparing to Larrson DFS Algorithm\".",
                 .stands = "open",
                 .options = e_node(Descent::larger)},
    EnodeReading{.name = "family_cross",
                 .title = "the same, children against the other node first",
                 .speaks_for = "Heading 5.5: \"Earlier\", before pairs of children are made.",
                 .speaks_against = "No caption tests a node with the children of the other.",
                 .stands = "against",
                 .options = e_node(Descent::cross)},
    EnodeReading{.name = "family_fewest",
                 .title = "the same, the node that leaves fewer pairs",
                 .speaks_for = "Heading 5.5: \"Earlier\", as fewer pairs are left.",
                 .speaks_against = "No caption tries one node and then the other.",
                 .stands = "open",
                 .options = e_node(Descent::fewest)},
    EnodeReading{.name = "front_both",
                 .title = "from the last frame's front, both nodes",
                 .speaks_for = kFrontFor,
                 .speaks_against = kFrontAgainst,
                 .stands = "against",
                 .options = from_front(Descent::both)},
    EnodeReading{.name = "front_larger",
                 .title = "from the last frame's front, larger node",
                 .speaks_for = kFrontFor,
                 .speaks_against = kFrontAgainst,
                 .stands = "against",
                 .options = from_front(Descent::larger)},
    EnodeReading{.name = "chain",
                 .title = "descends on while one child pair overlaps",
                 .speaks_for =
                     "Heading 5.5: \"Earlier Node detection\": it comes to the node where "
                     "pairs part without entering those above.",
                 .speaks_against = "No caption has it. It makes the box tests of family_both.",
                 .stands = "open",
                 .options = e_node(Descent::both),
                 .chain = true},
    EnodeReading{.name = "first_leaves",
                 .title = "stops at the first overlapping leaves",
                 .speaks_for = "Abstract: \"able to detect overlap between dynamic and static "
                               "models\"; figure 4.33, caption: \"Simple Overlap Checking\".",
                 .speaks_against = "Figure 4.35 shows all colliding boxes, in red; section "
                                   "1.2: \"to produce collision pairs\".",
                 .stands = "open",
                 .answer = EnodeAnswer::first_leaves,
                 .options = e_node(Descent::both)},
    EnodeReading{.name = "first_contact",
                 .title = "stops at the first triangles that touch",
                 .speaks_for = "Section 1.3: \"detecting object interference\", which is a yes or "
                               "no; abstract in Malay: \"nod yang bersentuhan\" (nodes that "
                               "touch).",
                 .speaks_against = "As first_leaves; and the captions of chapters 4 and 5 have no "
                                   "test of triangles.",
                 .stands = "open",
                 .answer = EnodeAnswer::first_contact,
                 .options = e_node(Descent::both)},
    EnodeReading{
        .name = "boxes_only",
        .title = "stops at an earlier level, boxes alone",
        .speaks_for =
            "Its name; section 1.2: \"for complex environment, faster intersection is more "
            "relevant compared to accuracy\"; question 7: \"how to measure the 'accuracy' of the "
            "technique\"; abstract in Malay: \"penyusuran antara nod yang bersentuhan antara objek "
            "dinamik dan statik\" (traversal between touching nodes of the moving and the static "
            "object).",
        .speaks_against = "Abstract: \"so that each of them can be bounded with single "
                          "Axis-Aligned Bounding Box\": SOMS is made for leaves. Figure 2.16, "
                          "caption: \"Further traversing will be required in order to find "
                          "accurate intersection point\". The answer has false contacts.",
        .stands = "against",
        .answer = EnodeAnswer::boxes_only,
        .options = e_node(Descent::both)},
};

/// Watches one frame after another.
class Watcher {
 public:
  explicit Watcher(const MovedTrip& moved)
      : moved_(moved), a_(*moved.trip().a.tree()), b_(*moved.trip().b.tree()) {}

  void look(FrameTraversal& traversal, std::size_t frame) {
    now_ = {};
    bool leaves = false;
    bool contact = false;
    const TraversalVisitor visitor{
        .leaf_pair =
            [&](NodePair pair) {
              ++now_.leaf_pairs;
              now_.triangle_pairs += std::uint64_t{a_.nodes[pair.a].count} * b_.nodes[pair.b].count;
              note(sum.leaves, leaves, true, frame);
              note(sum.contact, contact, !contact && moved_.contacts(frame, pair, 1) > 0, frame);
              return true;
            },
        .tested = [&](NodePair, bool) { ++now_.box_tests; },
        .entered = [&](NodePair) { ++now_.entered; }};
    traversal.run(frame, visitor);
    sum.whole += now_;
    if (!leaves) {
      sum.leaves.stopping += now_;
    }
    if (!contact) {
      sum.contact.stopping += now_;
    }
  }

  EnodeTripWork sum = {};

 private:
  /// Notes the first hit of a frame.
  void note(FirstHit& first, bool& found, bool hit, std::size_t frame) const {
    if (hit && !found) {
      found = true;
      first.to_hit += now_;
      first.stopping += now_;
      first.frames.push_back(frame);
    }
  }

  const MovedTrip& moved_;
  const Tree& a_;
  const Tree& b_;
  EnodeWork now_ = {};
};

}  // namespace

std::span<const EnodeReading> e_node_readings() {
  return kReadings;
}

EnodeWork& EnodeWork::operator+=(const EnodeWork& other) {
  box_tests += other.box_tests;
  entered += other.entered;
  leaf_pairs += other.leaf_pairs;
  triangle_pairs += other.triangle_pairs;
  return *this;
}

FirstHit& FirstHit::operator+=(const FirstHit& other) {
  to_hit += other.to_hit;
  stopping += other.stopping;
  frames.insert(frames.end(), other.frames.begin(), other.frames.end());
  return *this;
}

EnodeTripWork& EnodeTripWork::operator+=(const EnodeTripWork& other) {
  whole += other.whole;
  leaves += other.leaves;
  contact += other.contact;
  return *this;
}

EnodeTripWork e_node_work(const MovedTrip& moved, const EnodeReading& reading,
                          const Limits& limits) {
  const TripRacer racer{std::string(reading.name), reading.options, reading.chain};
  FrameTraversal traversal(moved, racer);
  Watcher watcher(moved);
  for (std::size_t frame = 0; frame < moved.frames(); ++frame) {
    check_stop(limits);
    watcher.look(traversal, frame);
  }
  return std::move(watcher.sum);
}

}  // namespace soms::reproduce
