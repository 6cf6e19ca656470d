/// \file
/// Bodies, options and answers, printed by `<<`:
/// "Overlap{any: true, 12 pairs, coverage: complete, cost: Cost{...}}".
#pragma once

#include <iosfwd>

namespace soms {

enum class Coverage;
enum class CrossingKind : unsigned char;
enum class OverlapMode;
enum class Partition : unsigned char;
enum class Relation : unsigned char;
enum class Side : unsigned char;
enum class Undecided : unsigned char;
class ClosedBody;
class DividedBody;
class WindingIndex;
struct AllHits;
struct AnyHit;
struct AnyHitBatch;
struct Body;
struct DividedPart;
struct Closest;
struct ClosestBatch;
struct ClosestHit;
struct ClosestHitBatch;
struct ClosestOptions;
struct Contains;
struct ContainsBatch;
struct ContainsOptions;
struct ContainsParts;
struct ContainsPartsBatch;
struct SignedClosest;
struct SignedClosestBatch;
struct Cost;
struct Distance;
struct DistanceBatch;
struct DistanceOptions;
struct NearTriangles;
struct Overlap;
struct PartSide;
struct OverlapBatch;
struct OverlapOptions;
struct Solid;
struct SolidBatch;
struct SolidOptions;
struct Ray;
struct RayOptions;
struct Segment;
struct Winding;
struct WindingBatch;
struct WindingOptions;
struct Within;
struct WithinBatch;
struct WithinOptions;

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const Body& value);
std::ostream& operator<<(std::ostream& out, const ClosedBody& value);
std::ostream& operator<<(std::ostream& out, const Contains& value);
std::ostream& operator<<(std::ostream& out, const ContainsBatch& value);
std::ostream& operator<<(std::ostream& out, const ContainsOptions& value);
std::ostream& operator<<(std::ostream& out, const DividedPart& value);
std::ostream& operator<<(std::ostream& out, const ContainsParts& value);
std::ostream& operator<<(std::ostream& out, const ContainsPartsBatch& value);
std::ostream& operator<<(std::ostream& out, const PartSide& value);
std::ostream& operator<<(std::ostream& out, const DividedBody& value);
std::ostream& operator<<(std::ostream& out, Partition value);
std::ostream& operator<<(std::ostream& out, const Cost& value);
std::ostream& operator<<(std::ostream& out, Coverage value);
std::ostream& operator<<(std::ostream& out, const Closest& value);
std::ostream& operator<<(std::ostream& out, const ClosestBatch& value);
std::ostream& operator<<(std::ostream& out, const ClosestOptions& value);
std::ostream& operator<<(std::ostream& out, const NearTriangles& value);
std::ostream& operator<<(std::ostream& out, const Distance& value);
std::ostream& operator<<(std::ostream& out, const DistanceBatch& value);
std::ostream& operator<<(std::ostream& out, const DistanceOptions& value);
std::ostream& operator<<(std::ostream& out, const Within& value);
std::ostream& operator<<(std::ostream& out, const WithinBatch& value);
std::ostream& operator<<(std::ostream& out, const WithinOptions& value);
std::ostream& operator<<(std::ostream& out, const Overlap& value);
std::ostream& operator<<(std::ostream& out, const OverlapBatch& value);
std::ostream& operator<<(std::ostream& out, const OverlapOptions& value);
std::ostream& operator<<(std::ostream& out, OverlapMode value);
std::ostream& operator<<(std::ostream& out, Relation value);
std::ostream& operator<<(std::ostream& out, const Ray& value);
std::ostream& operator<<(std::ostream& out, const Segment& value);
std::ostream& operator<<(std::ostream& out, const RayOptions& value);
std::ostream& operator<<(std::ostream& out, const ClosestHit& value);
std::ostream& operator<<(std::ostream& out, const ClosestHitBatch& value);
std::ostream& operator<<(std::ostream& out, const AnyHit& value);
std::ostream& operator<<(std::ostream& out, const AnyHitBatch& value);
std::ostream& operator<<(std::ostream& out, const AllHits& value);
std::ostream& operator<<(std::ostream& out, CrossingKind value);
std::ostream& operator<<(std::ostream& out, Side value);
std::ostream& operator<<(std::ostream& out, const SignedClosest& value);
std::ostream& operator<<(std::ostream& out, const SignedClosestBatch& value);
std::ostream& operator<<(std::ostream& out, const Solid& value);
std::ostream& operator<<(std::ostream& out, const SolidBatch& value);
std::ostream& operator<<(std::ostream& out, const SolidOptions& value);
std::ostream& operator<<(std::ostream& out, Undecided value);
std::ostream& operator<<(std::ostream& out, const Winding& value);
std::ostream& operator<<(std::ostream& out, const WindingBatch& value);
std::ostream& operator<<(std::ostream& out, const WindingIndex& value);
std::ostream& operator<<(std::ostream& out, const WindingOptions& value);

}  // namespace soms
