/// \file
/// Trees, shapes and their options, printed by `<<`: "Tree{23 nodes, 12 triangles}".
#pragma once

#include "soms/tree/build_options.h"
#include "soms/tree/file/shape_bytes.h"
#include "soms/tree/shape.h"

#include <iosfwd>

namespace soms {

class Shape;
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
std::ostream& operator<<(std::ostream& out, const Shape& value);
std::ostream& operator<<(std::ostream& out, const ShapeOptions& value);
std::ostream& operator<<(std::ostream& out, const OpenOptions& value);
std::ostream& operator<<(std::ostream& out, const TreeFileName& value);

}  // namespace soms
