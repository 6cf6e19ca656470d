/// \file
/// Trees, shapes and their options, printed by `<<`: "Tree{23 nodes, 12 triangles}".
#pragma once

#include <iosfwd>

namespace soms {

class Shape;
enum class AxisFrom;
enum class EmptySide;
enum class Layout;
enum class Rule;
enum class TreeCheck;
struct BuildOptions;
struct ExpectedVisits;
struct Node;
struct OpenOptions;
struct ShapeOptions;
struct Tree;
struct TreeFileName;
struct TreeStatistics;
struct Visits;

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const Tree& value);
std::ostream& operator<<(std::ostream& out, const Node& value);
std::ostream& operator<<(std::ostream& out, const TreeStatistics& value);
std::ostream& operator<<(std::ostream& out, const Visits& value);
std::ostream& operator<<(std::ostream& out, const ExpectedVisits& value);
std::ostream& operator<<(std::ostream& out, const BuildOptions& value);
std::ostream& operator<<(std::ostream& out, Rule value);
std::ostream& operator<<(std::ostream& out, AxisFrom value);
std::ostream& operator<<(std::ostream& out, EmptySide value);
std::ostream& operator<<(std::ostream& out, const Shape& value);
std::ostream& operator<<(std::ostream& out, const ShapeOptions& value);
std::ostream& operator<<(std::ostream& out, Layout value);
std::ostream& operator<<(std::ostream& out, TreeCheck value);
std::ostream& operator<<(std::ostream& out, const OpenOptions& value);
std::ostream& operator<<(std::ostream& out, const TreeFileName& value);

}  // namespace soms
