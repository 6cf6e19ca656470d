/// \file
/// Bodies, options and answers, printed by `<<`:
/// "Overlap{any: true, 12 pairs, coverage: complete, cost: Cost{...}}".
#pragma once

#include "soms/describe/print_answers.h"
#include "soms/query/closest.h"
#include "soms/query/contains.h"
#include "soms/query/contains_parts.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/ray.h"
#include "soms/query/self_overlap.h"
#include "soms/query/signed_closest.h"
#include "soms/query/solid.h"
#include "soms/query/winding.h"
#include "soms/query/within.h"

#include <iosfwd>

namespace soms {

class ClosedBody;
class DividedBody;
class WindingIndex;
struct AllHits;
struct Body;
struct DividedPart;
struct ContainsPartsBatch;
struct SignedClosestBatch;
struct NearTriangles;
struct OverlapBatch;
struct Ray;

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const Body& value);
std::ostream& operator<<(std::ostream& out, const ClosedBody& value);
std::ostream& operator<<(std::ostream& out, const DividedPart& value);
std::ostream& operator<<(std::ostream& out, const ContainsPartsBatch& value);
std::ostream& operator<<(std::ostream& out, const DividedBody& value);
std::ostream& operator<<(std::ostream& out, const NearTriangles& value);
std::ostream& operator<<(std::ostream& out, const OverlapBatch& value);
std::ostream& operator<<(std::ostream& out, const Ray& value);
std::ostream& operator<<(std::ostream& out, const AllHits& value);
std::ostream& operator<<(std::ostream& out, const SignedClosestBatch& value);
std::ostream& operator<<(std::ostream& out, const WindingIndex& value);

}  // namespace soms
