/// \file
/// Meshes and what is found in them, printed by `<<`: "Mesh{12 triangles, 8 vertices, 1 part}".
#pragma once

#include "soms/describe/print_answers.h"
#include "soms/geometry/mesh.h"
#include "soms/geometry/midpoint.h"
#include "soms/geometry/orientation.h"
#include "soms/geometry/point_distance.h"

#include <iosfwd>

namespace soms {

enum class FrameDoubt;
enum class Sign : signed char;
struct Attribute;
struct Closedness;
struct ClosednessOptions;
struct CoordinateFrame;
struct CommonPoints;
struct DefectOptions;
struct DefectPlaces;
struct Defects;
struct EdgeCounts;
struct EdgePlace;
struct Georeference;
struct MapConversion;
struct Mesh;
struct MeshView;
struct Part;
struct PartClosedness;
struct PartGroup;
struct PartRun;
struct PointDistance;
struct TriangleCopy;
struct TriangleDistance;
struct VertexCopy;

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const Mesh& value);
std::ostream& operator<<(std::ostream& out, const MeshView& value);
std::ostream& operator<<(std::ostream& out, const Attribute& value);
std::ostream& operator<<(std::ostream& out, const Part& value);
std::ostream& operator<<(std::ostream& out, const PartGroup& value);

std::ostream& operator<<(std::ostream& out, const PartRun& value);
std::ostream& operator<<(std::ostream& out, const Defects& value);
std::ostream& operator<<(std::ostream& out, const DefectPlaces& value);
std::ostream& operator<<(std::ostream& out, const DefectOptions& value);
std::ostream& operator<<(std::ostream& out, const EdgeCounts& value);
std::ostream& operator<<(std::ostream& out, const EdgePlace& value);
std::ostream& operator<<(std::ostream& out, const TriangleCopy& value);
std::ostream& operator<<(std::ostream& out, const VertexCopy& value);
std::ostream& operator<<(std::ostream& out, const Closedness& value);
std::ostream& operator<<(std::ostream& out, const ClosednessOptions& value);
std::ostream& operator<<(std::ostream& out, const PartClosedness& value);
std::ostream& operator<<(std::ostream& out, const CommonPoints& value);
std::ostream& operator<<(std::ostream& out, const TriangleDistance& value);
std::ostream& operator<<(std::ostream& out, const PointDistance& value);
std::ostream& operator<<(std::ostream& out, Sign value);
std::ostream& operator<<(std::ostream& out, const CoordinateFrame& value);
std::ostream& operator<<(std::ostream& out, const Georeference& value);
std::ostream& operator<<(std::ostream& out, const MapConversion& value);
std::ostream& operator<<(std::ostream& out, FrameDoubt value);

}  // namespace soms
