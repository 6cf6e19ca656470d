#include "thesis/claims/sources.h"

#include "soms/thesis/thesis_frames.h"
#include "soms/tree/option_names.h"
#include "soms/tree/rule/rules.h"

#include "thesis/trips/contenders.h"
#include "thesis/trips/frames.h"
#include "thesis/trips/levels.h"

#include <fmt/format.h>

#include <utility>

namespace soms::reproduce {

namespace {

std::string rules_used() {
  std::string names;
  for (const Contender& rule : thesis_rules(kObjectLevel)) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", rule.name);
  }
  return names;
}

std::string midpoint_used() {
  return std::string(name(thesis_options(Rule::soms).midpoint));
}

std::string c_vertex_used() {
  return std::to_string(thesis_options(Rule::soms).c_vertex);
}

std::string axis_from_used(Rule rule) {
  return std::string(name(thesis_options(rule).axis_from.value_or(entry(rule).axis_from)));
}

std::string empty_side_used() {
  return std::string(name(thesis_options(Rule::soms).empty_side));
}

std::string per_leaf_used() {
  return std::to_string(thesis_options(Rule::soms).per_leaf);
}

std::string root_level_used() {
  return std::to_string(thesis_options(Rule::soms).root_level);
}

std::string drive_used() {
  const std::vector<Vec3> path = city_drive();
  return fmt::format("{} frames from ({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g})", path.size(),
                     path.front().x, path.front().y, path.front().z, path.back().x, path.back().y,
                     path.back().z);
}

std::string scale_used() {
  return fmt::format("{:g} times as large as its file; other objects as long as that", kDriveScale);
}

std::string directions_used() {
  std::string names;
  for (const auto& [approach, word] : kApproaches) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", word);
  }
  return names;
}

std::string line_used(Approach from) {
  const ApproachLine line = approach_line(from);
  return fmt::format("comes from {}{}", line.side > 0 ? '+' : '-', "xyz"[line.axis]);
}

/// Offsets on a still box that is one unit wide.
std::string offsets_used() {
  const std::vector<Vec3> offsets = orientation_test({{0, 0, 0}, {1, 1, 1}}, Approach::right);
  return fmt::format("{} frames, {:g} to {:g} widths of the still object, {:g} a frame",
                     offsets.size(), offsets.front().x, offsets.back().x,
                     offsets[1].x - offsets[0].x);
}

std::vector<SourcedOption> rule_options() {
  constexpr std::string_view kGroup = "rules";
  return {
      {kGroup, "rules", rules_used(), Basis::caption,
       "SOMS and spatial median: abstract; object median and object mean: figures 4.1 "
       "and 4.7; that chapter 5 counts those two is not said"},
      {kGroup, "midpoint", midpoint_used(), Basis::caption,
       "figure 4.23: halfway between C and the middle of A and B; that the other rules "
       "use it too is ours"},
      {kGroup, "c_vertex", c_vertex_used(), Basis::ours,
       "figure 4.23 names A, B and C, not which corner of a file's triangle is C"},
      {kGroup, "axis_from of soms", axis_from_used(Rule::soms), Basis::stated,
       "abstract in Malay: the longest axis is calculated between the midpoints of the triangles; "
       "the abstract in English leaves both boxes open; the author's paper of 2012 splits the "
       "inner box"},
      {kGroup, "axis_from of spatial_median", axis_from_used(Rule::spatial_median), Basis::ours,
       "figure 4.4 shows minimum and maximum points of both techniques, its caption does not say "
       "of what"},
      {kGroup, "axis_from of object_median", axis_from_used(Rule::object_median), Basis::ours,
       "not mentioned"},
      {kGroup, "axis_from of object_mean", axis_from_used(Rule::object_mean), Basis::ours,
       "not mentioned"},
      {kGroup, "plane of soms", "midway between the least and the greatest midpoint on the axis",
       Basis::caption,
       "figure 4.6: the midpoint between the midpoints of two triangles; that these are the "
       "outermost two follows from the abstract, by minimum and maximum points"},
      {kGroup, "plane of spatial_median", "middle of the box of all corners", Basis::caption,
       "figure 4.1 names Ericson, whose rule this is; section 1.2: two equal parts of the object"},
      {kGroup, "plane of object_median", "none: half of the triangles to each side, by midpoint",
       Basis::caption,
       "figure 4.1 names Ericson, whose rule this is; section 1.2: the median point; how ties are "
       "divided is ours"},
      {kGroup, "plane of object_mean", "mean of the midpoints", Basis::caption,
       "figure 4.1 names Ericson, whose rule this is"},
      {kGroup, "empty_side", empty_side_used(), Basis::ours,
       "section 1.2: a hierarchy stops where it cannot be divided, and others go on by a "
       "heuristic, "
       "which SOMS does without at the earlier phase; tables 5.5 and 5.11 count such nodes; what "
       "becomes of one under spatial median is not said"},
      {kGroup, "ties on the axis", "x before y before z", Basis::ours,
       "figure 4.22 has Boolean functions for the longest axis; their order is not known here"},
      {kGroup, "side of the plane", "below the plane left; on the plane and above right",
       Basis::ours, "not mentioned"},
      {kGroup, "sum of object_mean", "in ascending order of triangle numbers, in double precision",
       Basis::ours, "not mentioned"},
      {kGroup, "arithmetic", "double precision, no fused operations", Basis::ours, "not mentioned"},
  };
}

std::vector<SourcedOption> tree_options() {
  constexpr std::string_view kGroup = "trees";
  return {
      {kGroup, "kind of tree", "binary, of boxes along the axes", Basis::stated,
       "abstract (binary tree, AABB) and section 1.3 (binary BVH of AABB)"},
      {kGroup, "construction", "top-down", Basis::caption, "heading 4.4.1"},
      {kGroup, "TreeID", "root 0, children 2i+1 and 2i+2, parent (i-1)/2 rounded down",
       Basis::caption, "figure 4.21, for the nodes 0, 1 and 4"},
      {kGroup, "level of the objects", std::to_string(kObjectLevel), Basis::caption,
       "table 5.3: the most that its arrays hold"},
      {kGroup, "level of the urban scene", std::to_string(kSceneLevel), Basis::caption,
       "tables 5.9 and 5.11; 12 in table 5.8 and 7 in figure 5.5, where this run uses "
       "them too"},
      {kGroup, "root_level", root_level_used(), Basis::caption,
       "figure 4.30: level 1 is one big box"},
      {kGroup, "per_leaf", per_leaf_used(), Basis::ours,
       "the abstract wants each triangle bounded by a box of its own, and section 1.2 says of "
       "others that they divide until each node contains one; that SOMS does is not said"},
  };
}

std::vector<SourcedOption> count_options() {
  constexpr std::string_view kGroup = "counts";
  return {
      {kGroup, "nodes with one triangle", "leaves with exactly one triangle", Basis::stated,
       "abstract: leaf nodes containing a single triangle; tables 5.3 and 5.9 by their captions"},
      {kGroup, "balance mode", "leaves with one to four triangles", Basis::caption,
       "tables 5.4 and 5.10"},
      {kGroup, "nodes that cannot be divided",
       "nodes above the last level, with two triangles or more, that the rule does not divide",
       Basis::ours,
       "table 5.5 adds \"no triangle\", table 5.11 counts nodes with a \"set of triangles\"; "
       "neither says more"},
      {kGroup, "balanced level",
       "the greatest level of which every node exists and holds a triangle", Basis::ours,
       "figures 4.2, 5.2, 5.3 and 5.5 and headings 3.5.3, 5.2.1, 5.2.2, 5.3.1 and 5.3.2 use the "
       "term; it is not defined in what we have"},
      {kGroup, "26 % more", "relative to spatial median's count; percentage points are shown too",
       Basis::ours, "abstract: 26 % more than spatial median; of what is not said"},
  };
}

std::vector<SourcedOption> traversal_options_used() {
  constexpr std::string_view kGroup = "traversals";
  return {
      {kGroup, "generic traversal",
       "ericson: of two overlapping nodes, divide the one of greater volume", Basis::ours,
       "heading 4.5.2.1 and figure 4.37 name Ericson, heading 5.4.1 the generic algorithm; which "
       "node it divides is not said"},
      {kGroup, "Larsson's traversal", "simultaneous: divide both nodes", Basis::ours,
       "heading 4.5.2.2 and figure 5.10 name it; its pseudo code is not known here"},
      {kGroup, "E-Node", "e_node: all child pairs are tested before any of them is entered",
       Basis::ours,
       "heading 5.5 (Earlier Node Detection) and figure 5.9; its steps are not known here"},
      {kGroup, "descent of E-Node", "both nodes are divided; the larger one is shown beside it",
       Basis::ours, "not mentioned"},
      {kGroup, "order of E-Node", "left before right", Basis::ours, "not mentioned"},
      {kGroup, "order of the other traversals", "depth first", Basis::caption,
       "heading 4.5.2 and figure 4.36; left before right is ours"},
      {kGroup, "first test", "the two roots", Basis::caption, "figure 4.32"},
      {kGroup, "pruning", "on; without it: figure 4.35", Basis::caption, "figure 4.35 shows both"},
      {kGroup, "start of E-Node", "at the roots; from the last front is shown beside it",
       Basis::ours, "not mentioned"},
      {kGroup, "overlap of boxes", "boxes that touch overlap", Basis::ours,
       "figure 4.33 shows the test; what it does with boxes that touch is not said"},
      {kGroup, "overlapping leaves", "exact tests of the triangles of overlapping leaves",
       Basis::ours,
       "the abstract in Malay speaks of nodes that touch; tests of triangles are not mentioned, "
       "and counts of traversals do not depend on them"},
      {kGroup, "boxes of what moves", "bounds of the moved corners, at every node", Basis::ours,
       "figure 4.13 and heading 4.3.3: boxes are updated; how is not known here"},
  };
}

std::vector<SourcedOption> test_options() {
  constexpr std::string_view kGroup = "tests";
  return {
      {kGroup, "directions", directions_used(), Basis::stated, "section 1.5, item 5"},
      {kGroup, "right", line_used(Approach::right), Basis::ours,
       "neither section 1.5 nor the captions of table 3.2 and figure 3.8 name an axis"},
      {kGroup, "top", line_used(Approach::top), Basis::ours,
       "neither section 1.5 nor the captions of table 3.2 and figure 3.8 name an axis"},
      {kGroup, "motion", "a moving object against a static one", Basis::stated,
       "section 1.5, item 5"},
      {kGroup, "object that moves", "a second one of the same kind; on drives the first object",
       Basis::ours, "figure 3.9 shows a test object; which it is is not said"},
      {kGroup, "offsets", offsets_used(), Basis::ours, "not mentioned"},
      {kGroup, "drive", drive_used(), Basis::ours,
       "figure 3.9 shows a test object beside the scene; its path is not said"},
      {kGroup, "scale of the object", scale_used(), Basis::ours, "not mentioned"},
  };
}

std::vector<SourcedOption> time_options() {
  constexpr std::string_view kGroup = "times";
  return {
      {kGroup, "quantities", "milliseconds, frames and frames per second", Basis::stated,
       "section 1.5, item 5"},
      {kGroup, "drawing", "off; drives-drawn times frames with drawing, too", Basis::ours,
       "section 1.5 names OpenGL and frames per second; whether drawing is timed is not said"},
      {kGroup, "average", "median of the rounds; tables of build times have the mean, too",
       Basis::ours,
       "the abstract, figures 5.2 to 5.5 and table 5.8 speak of an average, not of which"},
      {kGroup, "repetitions in figures 5.4 and 5.5", "1,000 builds (a tenth in a quick run)",
       Basis::caption, "figures 5.4 and 5.5"},
      {kGroup, "repetitions in table 5.8", "100 builds (a tenth in a quick run)", Basis::caption,
       "table 5.8"},
      {kGroup, "repetitions elsewhere", "as each caption says", Basis::ours, "not mentioned"},
      {kGroup, "time for a node", "time of the build divided by the number of nodes", Basis::ours,
       "tables 5.1 and 5.6 name it"},
      {kGroup, "percentage by level", "two columns: what the level adds, and all up to it",
       Basis::ours, "tables 5.2 and 5.7 name it; of what is not said"},
  };
}

std::vector<SourcedOption> model_options() {
  constexpr std::string_view kGroup = "models";
  return {
      {kGroup, "formats", "PLY and 3DS", Basis::stated, "section 1.5, item 1"},
      {kGroup, "bunny", "bun_zipper_res4.ply", Basis::ours,
       "section 1.5 names the model, the abstract an object of 948 triangles without its name; "
       "among the bunny's files this one has as many"},
      {kGroup, "Venus", "venus.ply", Basis::ours,
       "section 1.5 names the model; which file is not said"},
      {kGroup, "teapot", "teapot_1177.ply and teapot.ply", Basis::ours,
       "section 1.5 names the model; which file is not said, so both are run"},
      {kGroup, "urban scene", "u_mixed, u_boxes, u_plain: generated, 5,672 triangles each",
       Basis::ours, "abstract: 5,672 triangles; the scene is not available"},
      {kGroup, "size of the urban scene", "4 km by 4 km, of parts of 2 km by 2 km", Basis::caption,
       "figures 4.39 and 4.41"},
  };
}

}  // namespace

std::string_view name(Basis basis) {
  switch (basis) {
    case Basis::stated:
      return "stated";
    case Basis::caption:
      return "caption";
    case Basis::ours:
      break;
  }
  return "ours";
}

std::vector<SourcedOption> sourced_options() {
  std::vector<SourcedOption> all;
  for (const auto& group : {rule_options, tree_options, count_options, traversal_options_used,
                            test_options, time_options, model_options}) {
    for (SourcedOption& option : group()) {
      all.push_back(std::move(option));
    }
  }
  return all;
}

}  // namespace soms::reproduce
