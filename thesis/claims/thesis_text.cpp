// What the text of the thesis says twice and differently, what it states without a claim that a run
// could judge, and where its author said the same later.
#include "thesis/claims/sources.h"

#include <array>

namespace soms::reproduce {

namespace {

constexpr std::array kContradictions{
    Contradiction{"SketchUp", "section 1.5: version 6.4", "figure 4.38: version 7.0",
                  "none: scenes are generated here"},
    Contradiction{"origin of the objects",
                  "section 1.5: bunny, teapot and Venus, all from the Stanford repository",
                  "of the three, that repository has the bunny only",
                  "two public files of a teapot and one of a Venus are run; they may be others"},
    Contradiction{
        "orientation tests", "section 1.5: from left, right, top and bottom; table 3.2: four",
        "figures 5.6 to 5.8: right, left and top", "all four are run, and front and back besides"},
    Contradiction{"level and depth",
                  "figure 4.30: level 1 is the root; figure 4.18 uses depth and level as one",
                  "figure 4.16: depth 3, where the root is 0",
                  "the root is level 1 and has depth 0; root_level is an option"},
    Contradiction{"nodes that cannot be divided", "table 5.5: nodes with no triangle",
                  "table 5.11: sets of triangles that cannot be divided",
                  "both are counted: undividable nodes, and empty ones with empty_side chain"},
    Contradiction{"extent of the scene", "figure 4.39: 2 km by 2 km",
                  "the same caption and that of figure 4.41: a radius",
                  "scenes are squares of 4 km by 4 km, as the numbers say"},
    Contradiction{"name of a traversal", "heading 4.5.2.2 and figure 5.10: Larrson",
                  "the author of the method that is probably meant: Larsson",
                  "larsson, here and in the tables"},
    Contradiction{"page of table 5.3", "list of tables: page 117",
                  "the same list: table 5.2 on page 127, table 5.4 on page 128",
                  "none: a slip of the list"},
    Contradiction{"pages of the appendices", "list of appendices: A on page 146, B on page 149",
                  "contents: A on page 165, B on page 168; page 146 is in section 5.5",
                  "none: a slip of the list"},
    Contradiction{"what takes 0.2 ms",
                  "abstract in English: to detect an overlap between dynamic and static models",
                  "abstract in Malay: a traversal between nodes that touch",
                  "claim-enode-time shows all frames and those with contact, each with and without "
                  "tests of triangles"},
    Contradiction{"what is balanced", "abstract in English: a more balanced tree",
                  "abstract in Malay and figure 4.2: more balanced levels of the tree",
                  "claim-balance has metrics of both"},
    Contradiction{"where the questions are answered",
                  "section 1.2: all of them in chapters two, three and four",
                  "section 1.8: tests and results, and so the question how fast, in chapter 5",
                  "tables and figures of chapters 3 to 5 are run"},
    Contradiction{"texturing and lighting",
                  "section 1.5, item 2: the urban scene has basic texturing and lighting",
                  "section 1.5, item 3: both are left out, for a technique needs triangles alone",
                  "scenes are triangles without textures; pictures have a light of their own"},
    Contradiction{"breadth-first search", "list of abbreviations: BFS",
                  "headings and captions: depth-first traversals only",
                  "none is run: a breadth-first traversal tests the same pairs of boxes in another "
                  "order"},
    Contradiction{"object median", "section 1.2: it, too, is used with a heuristic to go on",
                  "a rule that halves by count can divide every set of two triangles or more",
                  "its column of nodes that cannot be divided is counted like the others"},
};

constexpr std::array kUnjudged{
    UnjudgedStatement{"the frame-rate of complex environments increases regardless number of "
                      "object being tested",
                      "section 1.6",
                      "against what the rate increases is not said, nor for how many objects; each "
                      "test that the text names moves one object past another",
                      "drives"},
    UnjudgedStatement{"without having to slow down the process of detecting interference in "
                      "complex environments",
                      "section 1.6",
                      "it is said of boxes along the axes in general, not of SOMS, and slower than "
                      "what is not said"},
    UnjudgedStatement{"able to minimize the computation cost and increase the performance for "
                      "complex environments when collision occurred",
                      "section 1.6",
                      "what is least would need every other technique; SOMS against spatial "
                      "median is judged, and the rules by cost are compared",
                      "modern"},
    UnjudgedStatement{
        "efficiently splitting the irregular triangles so that each of them can be "
        "bounded with single Axis-Aligned Bounding Box",
        "abstract",
        "a purpose, not a result; taken as one it fails at the greatest levels, where "
        "SOMS leaves triangles together: the item has the counts",
        "claim-single-leaves"},
    UnjudgedStatement{"SOMS is capable of creating an optimum level of BVH", "abstract",
                      "what is optimum is not defined; the text goes on with leaves of a single "
                      "triangle, which are judged",
                      "claim-single-leaves"},
    UnjudgedStatement{"BVH can easily be constructed using SOMS approach", "abstract",
                      "ease is not measured; the time of a build is", "claim-build-8-percent"},
    UnjudgedStatement{"specially designed to perform traversal testing for SOMS technique",
                      "abstract",
                      "a purpose, not a result; E-Node runs on trees of other rules beside those "
                      "of SOMS",
                      "claim-enode-faster"},
    UnjudgedStatement{"in practise, most 3D designer prefers to give some modification to the "
                      "object [...] Thus, the triangle of the corresponding object is not the same "
                      "as in theory",
                      "section 1.2",
                      "about what designers do; the spread of sizes in these models and cities is "
                      "shown",
                      "modern"},
    UnjudgedStatement{
        "suitable frame rates such as 30 - 60 frame per seconds", "section 1.1",
        "a need of applications, cited from others, not a result; the frames a second "
        "of the orientation tests stand beside it",
        "figure-5.6"},
    UnjudgedStatement{"how to measure the 'accuracy' of the technique", "section 1.2, question 7",
                      "a question; answers of all trees and traversals are compared here, and are "
                      "the exact ones",
                      "figure-5.6"},
    UnjudgedStatement{"Performing BV-BV testing is faster compared to primitive-primitives testing",
                      "section 1.1", "about bounding volumes in general, not about SOMS or E-Node"},
};

constexpr std::array kRestatements{
    Restatement{
        "H. A. Sulaiman, A. Bade, M. H. Abdullah: Quad Axis Separation Framework for "
        "Bounding-Volume Hierarchies Construction. Journal of Computing 4(7), 2012, 74-80",
        "SOMS encloses all midpoints in an inner AABB, which is what it splits; each set of "
        "triangles then gets its AABB, the outer one, until a node holds one triangle",
        "the axis is that of the inner box, as in this run"},
    Restatement{"H. A. Sulaiman, A. Bade: Bounding Volume Hierarchies for Collision Detection. In: "
                "Computer Graphics, InTech, 2012 (doi 10.5772/35555)",
                "a survey of trees, bounding volumes and splitting rules for collision detection",
                "no number of the thesis"},
    Restatement{
        "H. A. Sulaiman: Open World Collision Detection (a book; its description alone was "
        "available to us)",
        "the abstract of the thesis again, without its numbers: SOMS is faster than other common "
        "techniques, has more nodes of one triangle, and a higher level of balanced tree",
        "balance is meant as a level here: the balanced level is a metric of claim-balance"},
};

}  // namespace

std::span<const Restatement> restatements() {
  return kRestatements;
}

std::span<const Contradiction> contradictions() {
  return kContradictions;
}

std::span<const UnjudgedStatement> unjudged_statements() {
  return kUnjudged;
}

}  // namespace soms::reproduce
