/// \file
/// Traversals, their options and their counts, printed by `<<`.
#pragma once

#include <iosfwd>

namespace soms {

enum class BoxUpdate;
enum class Descent;
enum class EntryOrder;
enum class Traversal;
struct NodePair;
struct TraversalCounts;
struct TraversalOptions;

/// One line, as in soms/base/print.h.
std::ostream& operator<<(std::ostream& out, const TraversalCounts& value);
std::ostream& operator<<(std::ostream& out, const NodePair& value);
std::ostream& operator<<(std::ostream& out, const TraversalOptions& value);
std::ostream& operator<<(std::ostream& out, Traversal value);
std::ostream& operator<<(std::ostream& out, Descent value);
std::ostream& operator<<(std::ostream& out, EntryOrder value);
std::ostream& operator<<(std::ostream& out, BoxUpdate value);

namespace thesis {

struct CountedOverlap;

std::ostream& operator<<(std::ostream& out, const CountedOverlap& value);

}  // namespace thesis

}  // namespace soms
