#include "thesis/run/experiment.h"

#include "soms/base/error.h"

#include "thesis/experiments/experiments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr Needs kNothing{};
constexpr Needs kCities{.cities = true};
constexpr Needs kObjects{.objects = true};
constexpr Needs kScenes{.scenes = true};
constexpr Needs kObjectsAndScenes{.objects = true, .scenes = true};

constexpr std::array kExperiments{
    Experiment{"claim-models", "An object of 948 triangles and a scene of 5,672", Chapter::claims,
               kObjectsAndScenes, 1, claim_models},
    Experiment{"claim-fallback", "SOMS goes on where spatial median stops", Chapter::claims,
               kObjectsAndScenes, 1, claim_fallback},
    Experiment{"claim-single-leaves", "More leaves with a single triangle", Chapter::claims,
               kObjectsAndScenes, 1, claim_single_leaves},
    Experiment{"claim-26-percent", "26 % more of them in the urban scene", Chapter::claims, kScenes,
               1, claim_26_percent},
    Experiment{"claim-balance", "A more balanced tree", Chapter::claims, kObjectsAndScenes, 1,
               claim_balance},
    Experiment{"claim-level-7", "Level 7 is the balanced level of the urban scene", Chapter::claims,
               kScenes, 1, claim_level_7},
    Experiment{"claim-balanced", "A balanced tree is traversed faster", Chapter::claims,
               kObjectsAndScenes, 5, claim_balanced},
    Experiment{"claim-cheaper", "SOMS is cheaper to query than spatial median", Chapter::claims,
               kObjectsAndScenes, 10, claim_cheaper},
    Experiment{"claim-build-8-percent", "SOMS builds the tree of 948 triangles 8 % faster",
               Chapter::claims, kObjects, 30, claim_build_8_percent},
    Experiment{"claim-build-43-ms", "SOMS builds the tree of 948 triangles in 43 ms",
               Chapter::claims, kObjects, 1, claim_build_43_ms},
    Experiment{"claim-build-city", "SOMS builds the urban scene in less time", Chapter::claims,
               kScenes, 30, claim_build_city},
    Experiment{"claim-enode-faster", "E-Node is faster than Larsson's traversal", Chapter::claims,
               kObjectsAndScenes, 14, claim_enode_faster},
    Experiment{"claim-enode-earlier", "E-Node detects overlapping nodes earlier", Chapter::claims,
               kObjectsAndScenes, 6, claim_enode_earlier},
    Experiment{"claim-enode-time", "E-Node detects an overlap in 0.2 ms", Chapter::claims,
               kObjectsAndScenes, 4, claim_enode_time},
    Experiment{"table-3.1", "The objects: specification of the PLY models", Chapter::thesis,
               kObjects, 1, table_3_1},
    Experiment{"table-3.2", "The orientation tests: axis and direction", Chapter::thesis, kObjects,
               1, table_3_2},
    Experiment{"table-3.3", "The urban scenes: specification of the 3DS models", Chapter::thesis,
               kScenes, 1, table_3_3},
    Experiment{"figure-3.7", "The objects", Chapter::thesis, kObjects, 1, figure_3_7},
    Experiment{"figure-3.8", "The object and from where it is approached", Chapter::thesis,
               kObjects, 1, figure_3_8},
    Experiment{"figure-3.9", "The test object and the urban scenes", Chapter::thesis,
               kObjectsAndScenes, 1, figure_3_9},
    Experiment{"figure-4.1", "The common splitting rules", Chapter::thesis, kNothing, 1,
               figure_4_1},
    Experiment{"figure-4.2", "A small set divided by spatial median and by SOMS", Chapter::thesis,
               kNothing, 1, figure_4_2},
    Experiment{"figure-4.3", "Where the plane cannot divide", Chapter::thesis, kNothing, 1,
               figure_4_3},
    Experiment{"figure-4.4", "The boxes that count", Chapter::thesis, kNothing, 1, figure_4_4},
    Experiment{"figure-4.5", "SOMS in pseudo code", Chapter::thesis, kNothing, 1, figure_4_5},
    Experiment{"figure-4.6", "The plane of SOMS", Chapter::thesis, kNothing, 1, figure_4_6},
    Experiment{"figure-4.7", "Planes of all rules in space", Chapter::thesis, kNothing, 1,
               figure_4_7},
    Experiment{"figure-4.8", "How the box of a set is found", Chapter::thesis, kNothing, 1,
               figure_4_8},
    Experiment{"figure-4.9", "The coordinates of a box", Chapter::thesis, kNothing, 1, figure_4_9},
    Experiment{"figure-4.10", "The numbers of a box's corners", Chapter::thesis, kNothing, 1,
               figure_4_10},
    Experiment{"figure-4.11", "How a box is drawn, in pseudo code", Chapter::thesis, kNothing, 1,
               figure_4_11},
    Experiment{"figure-4.12", "The six faces of a box", Chapter::thesis, kNothing, 1, figure_4_12},
    Experiment{"figure-4.13", "The box of a set that moves", Chapter::thesis, kNothing, 1,
               figure_4_13},
    Experiment{"figure-4.14", "The class of a tree", Chapter::thesis, kNothing, 1, figure_4_14},
    Experiment{"figure-4.15", "How a tree begins", Chapter::thesis, kNothing, 1, figure_4_15},
    Experiment{"figure-4.16", "A tree of depth 3", Chapter::thesis, kNothing, 1, figure_4_16},
    Experiment{"figure-4.17", "Calls of split", Chapter::thesis, kNothing, 1, figure_4_17},
    Experiment{"figure-4.18", "Depth and level from the TreeID", Chapter::thesis, kNothing, 1,
               figure_4_18},
    Experiment{"figure-4.19", "How the nodes of a tree are made", Chapter::thesis, kNothing, 1,
               figure_4_19},
    Experiment{"figure-4.20", "How a node is made", Chapter::thesis, kNothing, 1, figure_4_20},
    Experiment{"figure-4.21", "TreeIDs and parents", Chapter::thesis, kNothing, 1, figure_4_21},
    Experiment{"figure-4.22", "Which axis is the longest", Chapter::thesis, kNothing, 1,
               figure_4_22},
    Experiment{"figure-4.23", "The center of a triangle", Chapter::thesis, kNothing, 1,
               figure_4_23},
    Experiment{"figure-4.24", "Triangles stored left and right", Chapter::thesis, kNothing, 1,
               figure_4_24},
    Experiment{"figure-4.25", "Triangles of the left and of the right child", Chapter::thesis,
               kNothing, 1, figure_4_25},
    Experiment{"figure-4.26", "Splitting an object in pseudo code", Chapter::thesis, kNothing, 1,
               figure_4_26},
    Experiment{"figure-4.27", "Triangles of each node in arrays by TreeID", Chapter::thesis,
               kObjectsAndScenes, 1, figure_4_27},
    Experiment{"figure-4.28", "A tree divided node by node", Chapter::thesis, kNothing, 1,
               figure_4_28},
    Experiment{"figure-4.29", "Rendering a level of a tree", Chapter::thesis, kObjects, 1,
               figure_4_29},
    Experiment{"figure-4.30", "The bunny's tree at levels 1, 3, 5 and 6", Chapter::thesis, kObjects,
               1, figure_4_30},
    Experiment{"figure-4.31", "Collision of two trees in pseudo code", Chapter::thesis, kNothing, 1,
               figure_4_31},
    Experiment{"figure-4.32", "The roots are tested first: broad phase", Chapter::thesis,
               kObjectsAndScenes, 1, figure_4_32},
    Experiment{"figure-4.33", "Overlap of two boxes", Chapter::thesis, kNothing, 1, figure_4_33},
    Experiment{"figure-4.34", "Is a node internal, in pseudo code", Chapter::thesis, kNothing, 1,
               figure_4_34},
    Experiment{"figure-4.35", "Traversal with pruning and without", Chapter::thesis, kObjects, 1,
               figure_4_35},
    Experiment{"figure-4.36", "Depth-first traversal in pseudo code", Chapter::thesis, kNothing, 1,
               figure_4_36},
    Experiment{"figure-4.37", "Ericson's generic traversal in pseudo code", Chapter::thesis,
               kObjects, 1, figure_4_37},
    Experiment{"figure-4.39", "A part of the city: terrain, then buildings", Chapter::thesis,
               kScenes, 1, figure_4_39},
    Experiment{"figure-4.40", "Part 1 of the city", Chapter::thesis, kScenes, 1, figure_4_40},
    Experiment{"figure-4.41", "The whole city", Chapter::thesis, kScenes, 1, figure_4_41},
    Experiment{"figure-4.42", "The city as it is loaded", Chapter::thesis, kScenes, 1, figure_4_42},
    Experiment{"figure-4.43", "The city written as 3DS and read back", Chapter::thesis, kScenes, 1,
               figure_4_43},
    Experiment{"figure-4.44", "The city's tree at levels 1, 3, 5 and 7", Chapter::thesis, kScenes,
               1, figure_4_44},
    Experiment{"figure-5.1", "The testing procedure", Chapter::thesis, kNothing, 1, figure_5_1},
    Experiment{"table-5.1", "Build time for each node, objects", Chapter::thesis, kObjects, 2,
               table_5_1},
    Experiment{"table-5.2", "Percentage of build time by level, objects", Chapter::thesis, kObjects,
               13, table_5_2},
    Experiment{"figure-5.2", "Build time of the objects at the balanced level of spatial median",
               Chapter::thesis, kObjects, 10, figure_5_2},
    Experiment{"table-5.3", "Nodes with one triangle at level 15, objects", Chapter::thesis,
               kObjects, 1, table_5_3},
    Experiment{"figure-5.3", "Build time of the objects at the balanced level of SOMS",
               Chapter::thesis, kObjects, 13, figure_5_3},
    Experiment{"table-5.4", "Balance mode: leaves with fewer than five triangles, objects",
               Chapter::thesis, kObjects, 1, table_5_4},
    Experiment{"figure-5.4",
               "1,000 builds of the urban scenes at the balanced level of spatial median",
               Chapter::thesis, kScenes, 12, figure_5_4},
    Experiment{"table-5.5", "Nodes that cannot be divided, objects", Chapter::thesis, kObjects, 1,
               table_5_5},
    Experiment{"figure-5.5", "1,000 builds of the urban scenes at level 7", Chapter::thesis,
               kScenes, 10, figure_5_5},
    Experiment{"table-5.6", "Build time for each node, urban scenes", Chapter::thesis, kScenes, 3,
               table_5_6},
    Experiment{"figure-5.6", "Orientation test right, generic traversal", Chapter::thesis, kObjects,
               1, figure_5_6},
    Experiment{"table-5.7", "Percentage of build time by level, urban scenes", Chapter::thesis,
               kScenes, 19, table_5_7},
    Experiment{"figure-5.7", "Orientation test left, generic traversal", Chapter::thesis, kObjects,
               1, figure_5_7},
    Experiment{"table-5.8", "100 builds of the urban scenes at level 12", Chapter::thesis, kScenes,
               4, table_5_8},
    Experiment{"figure-5.8", "Orientation test top, generic traversal", Chapter::thesis, kObjects,
               1, figure_5_8},
    Experiment{"table-5.9", "Nodes with one triangle at level 13, urban scenes", Chapter::thesis,
               kScenes, 1, table_5_9},
    Experiment{"figure-5.9", "E-Node explained", Chapter::thesis, kNothing, 1, figure_5_9},
    Experiment{"table-5.10", "Leaves with fewer than five triangles, urban scenes", Chapter::thesis,
               kScenes, 1, table_5_10},
    Experiment{"figure-5.10", "E-Node against Larsson's traversal", Chapter::thesis,
               kObjectsAndScenes, 10, figure_5_10},
    Experiment{"table-5.11", "Nodes that cannot be divided at level 13, urban scenes",
               Chapter::thesis, kScenes, 1, table_5_11},
    Experiment{"coverage", "What of the thesis is shown, and why the rest is not", Chapter::beyond,
               kNothing, 1, coverage},
    Experiment{"sources", "Where options come from, and contradictions of the thesis",
               Chapter::beyond, kNothing, 1, sources},
    Experiment{"orientation-bottom", "Orientation test bottom, generic traversal", Chapter::beyond,
               kObjects, 1, orientation_bottom},
    Experiment{"orientation-front", "Orientation test front, generic traversal", Chapter::beyond,
               kObjects, 1, orientation_front},
    Experiment{"orientation-back", "Orientation test back, generic traversal", Chapter::beyond,
               kObjects, 1, orientation_back},
    Experiment{"traversals", "Every traversal on every test", Chapter::beyond, kObjectsAndScenes,
               60, traversals},
    Experiment{"drives", "Drives through the scenes, with contact and without", Chapter::beyond,
               kObjectsAndScenes, 10, drives},
    Experiment{"drives-drawn", "The drives with drawing and without", Chapter::beyond,
               kObjectsAndScenes, 10, drives_drawn},
    Experiment{"balance", "Which rule balances best", Chapter::beyond, kObjectsAndScenes, 1,
               balance},
    Experiment{"options",
               "What midpoint, vertex C, axis, empty side, root level and leaf size change",
               Chapter::beyond, kObjectsAndScenes, 1, options},
    Experiment{"readings", "What else SOMS might be, and what speaks against it", Chapter::beyond,
               kObjectsAndScenes, 1, readings},
    Experiment{"readings-e-node", "What else E-Node might be, and what speaks against it",
               Chapter::beyond, kObjectsAndScenes, 6, readings_e_node},
    Experiment{"modern", "The models and scenes by modern measures", Chapter::beyond,
               kObjectsAndScenes, 20, modern},
    Experiment{"cities", "Real cities by modern measures", Chapter::beyond, kCities, 60, cities},
    Experiment{"spread", "Rules against the spread of triangle sizes", Chapter::beyond, kNothing,
               20, spread},
};

constexpr std::array<std::pair<std::string_view, Chapter>, 3> kChapters{
    {{"claims", Chapter::claims}, {"thesis", Chapter::thesis}, {"beyond", Chapter::beyond}}};

/// The chapter of this name; nothing if there is none.
std::optional<Chapter> chapter_named(std::string_view word) {
  const auto found = std::find_if(kChapters.begin(), kChapters.end(),
                                  [&](const auto& entry) { return entry.first == word; });
  return found == kChapters.end() ? std::nullopt : std::optional(found->second);
}

bool is_named(const Experiment& experiment, std::string_view word) {
  if (const std::optional<Chapter> chapter = chapter_named(word)) {
    return experiment.chapter == *chapter;
  }
  const std::string_view item = experiment.item;
  return item == word || item == fmt::format("table-{}", word) ||
         item == fmt::format("figure-{}", word);
}

Error unknown(std::string_view word) {
  std::string items = "claims, thesis, beyond";
  for (const Experiment& experiment : kExperiments) {
    items += fmt::format(", {}", experiment.item);
  }
  return Error(ErrorKind::usage, fmt::format("unknown item '{}'", word), "give one of: " + items);
}

}  // namespace

std::string Context::timed_step_words() const {
  return quick ? fmt::format(
                     " Quick run: every {}th frame of a drive and every {}th of an "
                     "orientation test is timed; counts are of all frames.",
                     timed_step(true), timed_step(false))
               : "";
}

int Context::repetitions(int whole) const {
  return quick ? std::min(whole, std::max(5, whole / 10)) : whole;
}

std::span<const Experiment> experiments() {
  return kExperiments;
}

std::vector<const Experiment*> experiments_named(std::span<const std::string_view> words) {
  std::vector<bool> wanted(kExperiments.size(), words.empty());
  for (const std::string_view word : words) {
    bool found = chapter_named(word).has_value();
    for (std::size_t i = 0; i < kExperiments.size(); ++i) {
      if (is_named(kExperiments[i], word)) {
        wanted[i] = true;
        found = true;
      }
    }
    if (!found) {
      throw unknown(word);
    }
  }
  std::vector<const Experiment*> result;
  for (std::size_t i = 0; i < kExperiments.size(); ++i) {
    if (wanted[i]) {
      result.push_back(&kExperiments[i]);
    }
  }
  return result;
}

}  // namespace soms::reproduce
