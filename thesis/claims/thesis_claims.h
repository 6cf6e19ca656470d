/// \file
/// The claims of the thesis as a table: what each says, where, what it demands of a number, and
/// what is nearest to the text. `judged` makes a claim of a row of the table and of what was
/// measured.
#pragma once

#include "thesis/claims/claim.h"
#include "thesis/claims/judged_subjects.h"

#include <array>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// What a claim demands of a number by one of its readings. Margins are half of the last digit that
/// the thesis gives, or ours, as the words say.
struct Demanded {
  Demand demand = {};
  std::string_view words = {};  ///< of a reading, where there are two
};

/// A row of the table: what is the same in every run. See `Claim` for what the columns mean.
struct ThesisClaim {
  std::string_view id;
  std::string_view statement;
  std::string_view source;
  std::array<Demanded, 2> demands;
  std::size_t named_triangles = 0;  ///< of the one model that a figure is about; 0: a comparison
  std::string_view nearest = {};    ///< empty where a level that was measured is a part of it
  std::string_view why_nearest;
  std::string_view settles;
};

/// How the readings nearest to the text begin, of both claims that compare E-Node.
inline constexpr std::string_view kNearestEnode =
    "family test, both nodes, against Larsson's (simultaneous)";

inline constexpr std::string_view kWhyNearestEnode =
    "The caption of figure 5.10 names Larsson's traversal as the opponent, and the name of E-Node "
    "says that nodes are detected earlier, by testing a family before entering it; the text does "
    "not say how either is programmed, so all four ways are alike near.";

inline constexpr std::array kThesisClaims{
    ThesisClaim{.id = "object_948",
                .statement = "An object has 948 triangles",
                .source = "abstract",
                .demands = {{{{.above = kObjectTriangles - 0.5, .below = kObjectTriangles + 0.5}}}},
                .named_triangles = kObjectTriangles,
                .nearest = "triangles of the file",
                .why_nearest = "The count is all that the abstract says.",
                .settles = "table 3.1 of the thesis, which says which object has which count"},
    ThesisClaim{.id = "scene_5672",
                .statement = "The urban scene has 5,672 triangles",
                .source = "abstract",
                .demands = {{{{.above = kSceneTriangles - 0.5, .below = kSceneTriangles + 0.5}}}},
                .named_triangles = kSceneTriangles,
                .nearest = "triangles of the file",
                .why_nearest = "The count is all that the abstract says.",
                .settles = "the scene of the thesis, which is not available"},
    ThesisClaim{
        .id = "no_fallback",
        .statement =
            "Where triangles differ in size, spatial median stops and SOMS goes on without a "
            "fallback",
        .source = "chapter 1 (problem); figures 4.3 and 4.6, tables 5.5 and 5.11 by their captions",
        .demands = {{{{.above = 0}}}},
        .nearest = "stop, inner axis, midpoint thesis",
        .why_nearest =
            "Trying the other axes may be a fallback itself; the axis between the midpoints is "
            "that of the abstract in Malay, and the midpoint that of figure 4.23.",
        .settles =
            "whether trying the other axes is one of the heuristics that chapter 1 speaks of, or "
            "what spatial median does without one: tables 5.5 and 5.11 have the counts"},
    ThesisClaim{
        .id = "more_single_leaves",
        .statement = "SOMS produces more leaf nodes with a single triangle than spatial median",
        .source = "abstract; levels by the captions of tables 5.3 and 5.9",
        .demands = {{{{.above = 0}}}},
        .nearest = "greatest level, stop, inner axis",
        .why_nearest =
            "Tables 5.3 and 5.9 count at the greatest level, table 5.5 counts nodes that cannot be "
            "divided, and the axis is that of the abstract in Malay.",
        .settles =
            "what the thesis' program does with a node that spatial median cannot divide: tables "
            "5.3 and 5.9 have the counts"},
    ThesisClaim{
        .id = "26_percent",
        .statement =
            "26 % more nodes with a single triangle by SOMS than by spatial median, on an urban "
            "scene of 5,672 triangles",
        .source = "abstract; level by the caption of table 5.9",
        .demands = {{{{.above = 25.5}, "at least 26 % (25.5)"},
                     {{.above = 21, .below = 31}, "about 26 %, within 5 points (ours)"}}},
        .named_triangles = kSceneTriangles,
        .nearest = "one tree, stop, inner axis, about 26 %, within 5 points (ours)",
        .why_nearest =
            "A share of spatial median's nodes is what \"26 % more nodes\" says, and a number said "
            "is a number meant; a floor, points, other empty sides and a tree for each object are "
            "further readings.",
        .settles =
            "the scene of the thesis, which is not available, or table 5.9, which has both counts "
            "and so says what the percentage is of"},
    ThesisClaim{
        .id = "more_balanced",
        .statement = "SOMS makes a more balanced tree than spatial median",
        .source = "abstract; tables 5.4 and 5.10 and figure 4.2 by their captions",
        .demands = {{{{.above = 0}}}},
        .nearest = "balance mode (tables 5.4 and 5.10), stop, inner axis",
        .why_nearest =
            "Tables 5.4 and 5.10 measure balance by leaves of fewer than five triangles; table 5.5 "
            "counts nodes that cannot be divided, and the axis is that of the abstract in Malay.",
        .settles =
            "tables 5.4 and 5.10, which have the counts, and section 3.5.3, which says what a "
            "balanced level is"},
    ThesisClaim{
        .id = "balanced_level_7",
        .statement = "The balanced level of SOMS on the urban scene is 7",
        .source = "figure 5.5 by its caption",
        .demands = {{{{.above = 6.5, .below = 7.5}}}},
        .named_triangles = kSceneTriangles,
        .nearest = "inner axis, the root is level 1",
        .why_nearest =
            "The axis between the midpoints is that of the abstract in Malay, and figure 4.30 has "
            "the root as level 1.",
        .settles =
            "the scene of the thesis, which is not available (put a SketchUp export of 5,672 "
            "triangles into the folder of --models), and section 3.5.3, which defines the level"},
    ThesisClaim{
        .id = "balanced_trees_are_traversed_faster",
        .statement = "A balanced tree is traversed faster than an unbalanced one",
        .source =
            "abstract: \"the speed of BVH tree traversal algorithm dropped for unbalanced tree\"",
        .demands = {{{{.below = 1}}}},
        .nearest = "SOMS and spatial median under stop, whichever is more balanced over the other",
        .why_nearest =
            "The thesis compares these two rules and calls the balance of their trees the reason; "
            "other rules and fallbacks, and trees that differ in nothing but balance, are further "
            "readings.",
        .settles =
            "what the thesis calls balanced: the text counts leaves of fewer than five triangles "
            "(tables 5.4 and 5.10) and speaks of balanced levels, but defines neither; here the "
            "tree of the higher balanced level is the more balanced one (ours)"},
    ThesisClaim{
        .id = "soms_is_cheaper_to_query",
        .statement = "A tree by SOMS is cheaper to query than a tree by spatial median",
        .source =
            "chapter 1 (problem, aim): \"increase the efficiency in collision detection handling\"",
        .demands = {{{{.below = 1}}}},
        .nearest = "empty side stop, traversal ericson",
        .why_nearest =
            "Figures 5.6 to 5.8 time the generic traversal, which is Ericson's, and table 5.5 "
            "counts nodes that cannot be divided.",
        .settles =
            "what the thesis does with a node that spatial median cannot divide, and its scene"},
    ThesisClaim{
        .id = "build_8_percent",
        .statement = "SOMS builds the tree of 948 triangles 8 % faster than spatial median",
        .source = "abstract",
        .demands = {{{{.above = 7.5}, "at least 8 % (7.5)"},
                     {{.above = 3, .below = 13}, "about 8 %, within 5 points (ours)"}}},
        .named_triangles = kObjectTriangles,
        .why_nearest =
            "The captions of chapter 4 describe a builder that copies lists, figure 5.3 times the "
            "objects at SOMS' balanced level, and a number said is a number meant; a floor is "
            "another reading.",
        .settles =
            "the thesis' program, or its chapter 5: the level, and what each rule's builder does "
            "at a node"},
    ThesisClaim{
        .id = "build_43_ms",
        .statement = "SOMS builds the tree of 948 triangles in 43 ms",
        .source = "abstract",
        .demands = {{{{.above = 42.5, .below = 43.5}}}},
        .named_triangles = kObjectTriangles,
        .why_nearest =
            "The captions of chapter 4 describe a builder that copies lists, and figure 5.3 times "
            "the objects at SOMS' balanced level.",
        .settles = "the thesis' program on a machine of its time"},
    ThesisClaim{
        .id = "build_city",
        .statement = "SOMS builds the tree of the urban scene in less time than spatial median",
        .source = "chapter 1, 1.2; figures 5.4 and 5.5 and table 5.8 by their captions",
        .demands = {{{{.above = 0}}}},
        .why_nearest =
            "Figure 5.5 times 1,000 builds at level 7, table 5.11 counts nodes that cannot be "
            "divided, and the captions of chapter 4 describe a builder that copies lists.",
        .settles = "the thesis' scene, and what its program does where a side is empty"},
    ThesisClaim{
        .id = "enode_faster",
        .statement = "E-Node is faster than Larsson's depth-first traversal",
        .source = "abstract (\"more efficient and faster\"); the opponent: caption of figure 5.10",
        .demands = {{{{.below = 1}}}},
        .nearest = kNearestEnode,
        .why_nearest = kWhyNearestEnode,
        .settles =
            "the pseudo code of E-Node and of Larsson's traversal in chapter 4, and whether the "
            "program of the thesis recurses"},
    ThesisClaim{
        .id = "enode_earlier",
        .statement =
            "Earlier Node detection: E-Node comes to an overlap earlier than Larsson's depth-first "
            "traversal",
        .source = "name of E-Node: heading of section 5.5",
        .demands = {{{{.below = 1}}}},
        .nearest = kNearestEnode,
        .why_nearest = kWhyNearestEnode,
        .settles = "the pseudo code of E-Node in chapter 4: what it does earlier, and than what"},
    ThesisClaim{
        .id = "enode_time",
        .statement =
            "E-Node detects the overlap of a moving and a static object in 0.2 ms on average, in "
            "the complex environment",
        .source = "abstract",
        .demands = {{{{.below = 0.2}}}},
        .named_triangles = kSceneTriangles,
        .nearest = "family test, both nodes",
        .why_nearest =
            "Figure 5.10 compares E-Node with Larsson's traversal, which we take to descend both "
            "nodes; the larger node alone is a reading of ours.",
        .settles = "the scene of the thesis and a machine of its time"},
};

/// The row of this name. \pre The table has one.
[[nodiscard]] constexpr const ThesisClaim& thesis_claim(std::string_view id) {
  for (const ThesisClaim& claim : kThesisClaims) {
    if (claim.id == id) {
      return claim;
    }
  }
  throw std::logic_error("the thesis has no such claim");
}

/// What a claim demands by its first reading.
[[nodiscard]] constexpr Demand demand_of(std::string_view id) {
  return thesis_claim(id).demands[0].demand;
}

/// A claim of the table with its rows, each judged or not by `judge_subjects`. `nearest` where the
/// table leaves it open.
[[nodiscard]] Claim judged(const ThesisClaim& claim, std::vector<ClaimRow> rows,
                           std::string nearest = {});

}  // namespace soms::reproduce
