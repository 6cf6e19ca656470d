#include "soms/tree/check.h"

#include "soms/tree/build.h"

#include "tests/tree/inputs.h"

#include <functional>
#include <string>

namespace soms {
namespace {

TEST(FindFault, PassesWholeTreesAndEmptyOnes) {
  const Mesh mesh = test::make_input(test::Input::random, 60);
  EXPECT_EQ(find_fault(build(mesh), mesh), "");
  EXPECT_EQ(find_fault(build(mesh, thesis_options(Rule::soms)), mesh), "");
  EXPECT_EQ(find_fault(Tree{}, Mesh{}), "");
}

TEST(FindFault, NamesEachFault) {
  struct Case {
    const char* says;
    std::function<void(Tree&)> spoil;
  };

  const std::vector<Case> cases{
      {"primitives for", [](Tree& t) { t.primitives.pop_back(); }},
      {"no permutation", [](Tree& t) { t.primitives[3] = t.primitives[4]; }},
      {"no permutation", [](Tree& t) { t.primitives[3] = 60; }},
      {"without nodes", [](Tree& t) { t.nodes.clear(); }},
      {"root", [](Tree& t) { t.nodes[0].count = 59; }},
      {"root", [](Tree& t) { t.nodes[0].id = 1; }},
      {"another box than its children", [](Tree& t) { t.nodes[0].bounds.upper.x += 1; }},
      {"another box", [](Tree& t) { t.nodes.back().bounds.lower.y -= 1; }},
      {"another box", [](Tree& t) { std::swap(t.primitives[0], t.primitives[59]); }},
      {"children's do not make up", [](Tree& t) { ++t.nodes[1].first; }},
      {"children's do not make up", [](Tree& t) { t.nodes[t.nodes[0].right].count -= 1; }},
      {"another depth", [](Tree& t) { t.nodes[1].depth = 2; }},
      {"2i+1", [](Tree& t) { t.nodes[1].id = 2; }},
      {"2i+1", [](Tree& t) { t.nodes[1].id = kNoTreeId; }},
      {"beyond the nodes", [](Tree& t) { t.nodes[0].right = 100000; }},
      {"no left one", [](Tree& t) { t.nodes.back().right = 1; }},
      {"children's do not make up", [](Tree& t) { std::swap(t.nodes[0].left, t.nodes[0].right); }},
      {"no parent", [](Tree& t) { t.nodes.push_back(t.nodes.back()); }},
  };
  const Mesh mesh = test::make_input(test::Input::random, 60);
  for (const Case& c : cases) {
    SCOPED_TRACE(c.says);
    Tree tree = build(mesh, thesis_options(Rule::object_median));
    c.spoil(tree);
    const std::string fault = find_fault(tree, mesh);
    EXPECT_NE(fault.find(c.says), std::string::npos) << fault;
  }
}

TEST(FindFault, SeesNodesOutOfDepthFirstOrder) {
  const Mesh mesh = test::make_input(test::Input::random, 4);
  Tree tree = build(mesh, thesis_options(Rule::object_median));
  ASSERT_EQ(tree.nodes.size(), 7U);
  // The two leaves of each side change places with all their links: sound but for the order.
  std::swap(tree.nodes[2], tree.nodes[3]);
  std::swap(tree.nodes[1].left, tree.nodes[1].right);
  EXPECT_NE(find_fault(tree, mesh).find("depth-first"), std::string::npos);
}

TEST(FindFault, SeesTreesOfTheWrongMesh) {
  const Mesh mesh = test::make_input(test::Input::random, 20, 1);
  const Mesh other = test::make_input(test::Input::random, 20, 2);
  EXPECT_NE(find_fault(build(mesh), other), "");
  EXPECT_NE(find_fault(build(mesh), Mesh{}), "");
  EXPECT_NE(find_fault(Tree{}, mesh), "");
}

}  // namespace
}  // namespace soms
