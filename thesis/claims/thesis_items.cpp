// The tables and figures of the thesis, by its lists of tables and figures.
#include "thesis/claims/coverage.h"

#include <array>

namespace soms::reproduce {

namespace {

constexpr ThesisItem shown_table(std::string_view number, std::string_view subject) {
  return {.kind = ThesisItemKind::table, .number = number, .subject = subject};
}

constexpr ThesisItem shown(std::string_view number, std::string_view subject) {
  return {.number = number, .subject = subject};
}

constexpr ThesisItem elsewhere(std::string_view number, std::string_view subject,
                               std::string_view item) {
  return {.number = number, .subject = subject, .elsewhere = item};
}

constexpr ThesisItem not_shown(std::string_view number, std::string_view subject,
                               std::string_view why) {
  return {.number = number, .subject = subject, .why_not = why};
}

constexpr std::string_view kPictureOfOthers =
    "A picture from the work of others in the literature review; it shows nothing of SOMS or "
    "E-Node.";
constexpr std::string_view kOtherVolumes =
    "Literature review of bounding volumes that the thesis does not use: its trees have boxes "
    "along the axes.";
constexpr std::string_view kOnlyTitle =
    "A diagram of which only the title was available to us: the caption does not say what is in "
    "it.";

constexpr ThesisItem literature(std::string_view number, std::string_view subject) {
  return {.kind = ThesisItemKind::table,
          .number = number,
          .subject = subject,
          .why_not = "Literature review: a list of the work of others; there is nothing to run."};
}

constexpr std::array kItems{
    literature("2.1", "Earlier work on splitting rules"),
    literature("2.2", "What others measured in their tests of hierarchies"),
    shown_table("3.1", "Specification of the PLY objects"),
    shown_table("3.2", "The four orientation tests"),
    shown_table("3.3", "Specification of the 3DS objects"),
    shown_table("5.1", "Build time for each node, objects"),
    shown_table("5.2", "Percentage of build time by level, objects"),
    shown_table("5.3", "Nodes with one triangle at level 15, objects"),
    shown_table("5.4", "Leaves with fewer than five triangles, objects"),
    shown_table("5.5", "Nodes that cannot be divided, objects, by level"),
    shown_table("5.6", "Build time for each node, urban scene"),
    shown_table("5.7", "Percentage of build time by level, urban scene"),
    shown_table("5.8", "Mean of 100 builds of the urban scene at level 12"),
    shown_table("5.9", "Nodes with one triangle at level 13, urban scene"),
    shown_table("5.10", "Leaves with fewer than five triangles, urban scene"),
    shown_table("5.11", "Nodes that cannot be divided at level 13, urban scene"),

    not_shown("2.1", "Virtual Los Angeles, a complex environment", kPictureOfOthers),
    not_shown("2.2", "Purposes of complex environments", kOnlyTitle),
    not_shown("2.3", "A city made by an automatic system", kPictureOfOthers),
    not_shown("2.4", "Classes of collision detection", kOnlyTitle),
    not_shown("2.5", "Tangential and boundary collision", kPictureOfOthers),
    not_shown("2.6", "Discrete and continuous collision detection",
              "Literature review; no caption of the thesis' own tests speaks of continuous "
              "detection."),
    not_shown("2.7", "Space subdivision and bounding-volume hierarchy",
              "Literature review; the thesis builds hierarchies and does not subdivide space."),
    not_shown("2.8", "Top-down, bottom-up and insertion",
              "Literature review; of the three ways the thesis uses top-down only."),
    not_shown("2.9", "Three ways to insert a primitive", kPictureOfOthers),
    not_shown("2.10", "A hierarchy of spheres and an unbalanced binary tree", kOtherVolumes),
    not_shown("2.11", "A traversal of two hierarchies by others",
              "An algorithm of others; the caption does not give it."),
    elsewhere("2.12", "Splitting at the object median, object mean and spatial median",
              "figure-4.1"),
    not_shown("2.13", "Splitting an oriented box along its farthest axis", kOtherVolumes),
    not_shown("2.14", "A tree of oriented boxes", kOtherVolumes),
    not_shown("2.15", "Characteristics of hierarchical trees", kOnlyTitle),
    elsewhere("2.16", "A traversal visits only nodes that intersect", "figure-4.35"),
    not_shown("2.17", "Common bounding volumes", kOtherVolumes),
    not_shown("2.18", "Three representations of a box along the axes", kPictureOfOthers),
    not_shown("2.19", "Representation of a sphere", kOtherVolumes),
    not_shown("2.20", "Making an oriented box", kOtherVolumes),
    not_shown("2.21", "A slab between two parallel planes", kOtherVolumes),
    not_shown("2.22", "Two models in oriented convex polyhedra", kOtherVolumes),
    not_shown("2.23", "Four attributes of bounding volumes", kOnlyTitle),

    not_shown("3.1", "The author's plan of research",
              "A chart of how the author worked; a program cannot show it."),
    not_shown("3.2", "Phases of the framework", kOnlyTitle),
    not_shown("3.3", "Parts of the author's system for setting up and testing an environment",
              kOnlyTitle),
    not_shown("3.4", "Steps to make a node", kOnlyTitle),
    not_shown("3.5", "Steps to build and to update a hierarchy", kOnlyTitle),
    elsewhere("3.6", "Testing procedure", "figure-5.1"),
    shown("3.7", "The three PLY objects"),
    shown("3.8", "The four orientation tests"),
    shown("3.9", "The urban scene and the test object"),

    shown("4.1", "The common splitting rules"),
    shown("4.2", "A small set divided by spatial median and by SOMS"),
    shown("4.3", "Where the plane cannot divide"),
    shown("4.4", "The boxes that count"),
    shown("4.5", "SOMS in pseudo code"),
    shown("4.6", "The plane of SOMS"),
    shown("4.7", "Planes of all rules in space"),
    shown("4.8", "Loops that find the least and greatest coordinates"),
    shown("4.9", "Coordinates of a box"),
    shown("4.10", "Numbers of the corners of a box"),
    shown("4.11", "Pseudo code: drawing a box"),
    shown("4.12", "Six faces of a box in the order in which OpenGL reads them"),
    shown("4.13", "Moving a box"),
    shown("4.14", "The class of the tree"),
    shown("4.15", "Initialization of the tree"),
    shown("4.16", "Construction of a tree of depth 3"),
    shown("4.17", "Pseudo code: calling the split function"),
    shown("4.18", "Depth or level of a node"),
    shown("4.19", "Pseudo code: making a node"),
    shown("4.20", "Pseudo code: making a node of the tree of boxes"),
    shown("4.21", "TreeIDs of nodes, their children and parents"),
    shown("4.22", "Which axis is the longest"),
    shown("4.23", "Center of a triangle"),
    shown("4.24", "Storing and counting the triangles on the left and on the right"),
    shown("4.25", "Triangles of the left and of the right child"),
    shown("4.26", "Pseudo code: splitting"),
    shown("4.27", "Triangles of each node in arrays, by TreeID"),
    shown("4.28", "Splitting a tree, node by node"),
    shown("4.29", "Rendering a level of a tree"),
    shown("4.30", "The bunny's tree at levels 1, 3, 5 and 6"),
    shown("4.31", "Pseudo code: traversal of two trees"),
    shown("4.32", "Test of the roots: the broad phase"),
    shown("4.33", "Overlap of two boxes"),
    shown("4.34", "Pseudo code: is a node internal"),
    shown("4.35", "Traversal with pruning and without"),
    shown("4.36", "Pseudo code: depth-first traversal"),
    shown("4.37", "Pseudo code: Ericson's generic traversal"),
    not_shown("4.38", "SketchUp 7.0, in which the urban scene was modeled",
              "A screenshot of software of its time; the scene itself is not available."),
    shown("4.39", "Terrain and buildings of a part of 2 km by 2 km"),
    shown("4.40", "Part 1 of the urban scene"),
    shown("4.41", "The whole city of 4 km by 4 km"),
    shown("4.42", "The city as it is loaded"),
    shown("4.43", "Reading a 3DS file"),
    shown("4.44", "The city's tree at a level"),

    shown("5.1", "Testing procedure"),
    shown("5.2", "Build time of the objects at the balanced level of spatial median"),
    shown("5.3", "Build time of the objects at the balanced level of SOMS"),
    shown("5.4", "1,000 builds of the urban scene by both rules"),
    shown("5.5", "1,000 builds of the urban scene at level 7"),
    shown("5.6", "Orientation test right"),
    shown("5.7", "Orientation test left"),
    shown("5.8", "Orientation test top"),
    shown("5.9", "E-Node"),
    shown("5.10", "E-Node against Larsson's traversal"),
};

}  // namespace

std::span<const ThesisItem> thesis_items() {
  return kItems;
}

}  // namespace soms::reproduce
