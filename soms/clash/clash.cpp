#include "soms/clash/clash.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/geometry/contact_box.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/scene/broad_phase.h"
#include "soms/scene/detail/contact_place.h"
#include "soms/scene/detail/widened.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>

namespace soms {

namespace {

/// Pairs are dealt out to threads in pieces of so many: one may take a microsecond or a second.
constexpr std::size_t kPairsOfAChunk = 8;

/// The box around a part where its pose has moved it.
Box moved_box(const Body& body) {
  Box box;
  for (std::size_t i = 0; i < body.shape.mesh().triangles.size(); ++i) {
    box.grow(bounds(detail::moved_triangle(body, static_cast<TriangleId>(i))));
  }
  return box;
}

void add_boxes(std::span<const PartBody> parts, double margin, std::vector<Box>& boxes) {
  for (const PartBody& part : parts) {
    boxes.push_back(detail::widened(moved_box(part.body), margin));
  }
}

std::vector<PartNumbers> meeting(const std::vector<Box>& boxes, std::uint32_t first_of_b,
                                 BroadPhase& broad_phase, const ClashOptions& options) {
  std::vector<PartNumbers> pairs;
  for (const auto& [i, j] : broad_phase.find(boxes)) {
    const PartNumbers pair{i, j - first_of_b};
    if (!options.wanted || options.wanted(pair.first, pair.second)) {
      pairs.push_back(pair);
    }
  }
  return pairs;
}

ClashKind kind_of(Relation relation) {
  switch (relation) {
    case Relation::crossing:
      return ClashKind::crossing;
    case Relation::a_in_b:
    case Relation::b_in_a:
      return ClashKind::inside;
    case Relation::same:
      return ClashKind::same;
    case Relation::touching:
      return ClashKind::touching;
    case Relation::clear:
      return ClashKind::near;
    case Relation::undecided:
      break;
  }
  return ClashKind::undecided;
}

/// Where the surfaces of two parts meet, by all pairs of triangles that do.
void place_contact(const Body& a, const Body& b, std::span<const TrianglePair> pairs,
                   Clash& clash) {
  std::vector<std::pair<Triangle, Triangle>> triangles;
  triangles.reserve(pairs.size());
  for (const TrianglePair& pair : pairs) {
    triangles.emplace_back(detail::moved_triangle(a, pair.first),
                           detail::moved_triangle(b, pair.second));
    grow_by_contact(clash.box, triangles.size() - 1, triangles.back().first,
                    triangles.back().second);
  }
  clash.triangle_pairs = pairs.size();
  clash.place = detail::contact_place(triangles).point;
}

/// Decides one pair of parts after the other, and adds up the cost.
class PairOfParts {
 public:
  PairOfParts(const ClashOptions& options, const Parallel& parallel)
      : options_(options), alone_{.threads = 1, .stop = parallel.stop} {}

  /// The clash of two parts, if they are not clear. Nothing is known of it where `cut` says so
  /// afterwards. Which one is named first changes nothing else.
  [[nodiscard]] std::optional<Clash> decide(const PartBody& a, const PartBody& b);

  /// The deadline passed before the last pair was decided.
  [[nodiscard]] bool cut() const { return cut_; }

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  template <class Answer>
  [[nodiscard]] Answer counted(Answer answer) {
    cost_ += answer.cost;
    cut_ = cut_ || answer.coverage == Coverage::cut;
    return answer;
  }

  void meet(const Body& a, const Body& b, Clash& clash) {
    const Overlap met = counted(overlap(a, b, {.deadline = options_.deadline}, alone_));
    if (met.any && !cut_) {
      place_contact(a, b, met.pairs, clash);
    }
  }

  /// The gap of parts whose surfaces do not meet; false if it exceeds `at_most`.
  bool measure(const Body& a, const Body& b, double at_most, Clash& clash) {
    const Distance gap =
        counted(distance(a, b, {.at_most = at_most, .deadline = options_.deadline}, alone_));
    if (gap.farther || cut_) {
      return false;
    }
    clash.gap = gap.distance;
    clash.box.grow(gap.point_a);
    clash.box.grow(gap.point_b);
    clash.place = clash.box.center();
    return true;
  }

  [[nodiscard]] std::optional<Clash> decide_in_order(const PartBody& a, const PartBody& b);

  [[nodiscard]] std::optional<Clash> of_clear(const Body& a, const Body& b, Clash clash) {
    if (!options_.within || !measure(a, b, *options_.within, clash)) {
      return std::nullopt;
    }
    clash.kind = ClashKind::near;
    clash.relation = Relation::clear;
    return clash;
  }

  const ClashOptions& options_;
  Parallel alone_;
  bool cut_ = false;
  Cost cost_;
};

/// A vertex of `inner`, and the box around it all.
void place_inside(const Body& inner, Clash& clash) {
  clash.place = detail::moved_triangle(inner, 0).a;
  clash.box = moved_box(inner);
}

/// An order of parts that does not depend on their numbers: the contact of many triangles, and the
/// nearest points of parallel faces, have a place each, which must not change with the order.
bool comes_first(const Body& a, const Body& b) {
  const auto place = [](const Body& body) {
    const Box box = body.shape.bounds();
    return std::tuple(box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z,
                      body.shape.mesh().triangles.size(), body.pose.m);
  };
  const auto of_a = place(a);
  const auto of_b = place(b);
  return of_a != of_b ? of_a < of_b : corner_hash(a.shape.mesh()) < corner_hash(b.shape.mesh());
}

std::optional<Clash> PairOfParts::decide(const PartBody& a, const PartBody& b) {
  if (!comes_first(b.body, a.body)) {
    return decide_in_order(a, b);
  }
  std::optional<Clash> clash = decide_in_order(b, a);
  if (clash && clash->kind == ClashKind::inside) {
    clash->relation = clash->relation == Relation::a_in_b ? Relation::b_in_a : Relation::a_in_b;
  }
  return clash;
}

std::optional<Clash> PairOfParts::decide_in_order(const PartBody& a, const PartBody& b) {
  constexpr double kAnyGap = std::numeric_limits<double>::infinity();
  cut_ = false;
  Clash clash;
  if (!a.closed || !b.closed) {
    meet(a.body, b.body, clash);
    if (clash.triangle_pairs == 0 && !cut_) {
      if (!overlaps(moved_box(a.body), moved_box(b.body))) {
        return of_clear(a.body, b.body, clash);
      }
      measure(a.body, b.body, kAnyGap, clash);
    }
    clash.why = Undecided::open;
    return clash;
  }
  const Solid answer =
      counted(solid(*a.closed, *b.closed, {.deadline = options_.deadline}, alone_));
  if (cut_) {
    return std::nullopt;
  }
  if (answer.relation == Relation::clear) {
    return of_clear(a.body, b.body, clash);
  }
  clash.relation = answer.relation;
  clash.kind = kind_of(answer.relation);
  if (answer.surfaces_meet) {
    meet(a.body, b.body, clash);
  } else {
    measure(a.body, b.body, kAnyGap, clash);
    if (clash.kind == ClashKind::inside) {
      place_inside(answer.relation == Relation::a_in_b ? a.body : b.body, clash);
    }
  }
  return clash;
}

void check_numbers(std::span<const PartBody> a, std::span<const PartBody> b,
                   std::span<const PartNumbers> pairs) {
  for (const auto& [i, j] : pairs) {
    if (i >= a.size() || j >= b.size()) {
      throw Error(ErrorKind::out_of_range,
                  "parts " + std::to_string(i) + " and " + std::to_string(j) + " of " +
                      std::to_string(a.size()) + " and " + std::to_string(b.size()),
                  "give numbers of parts that exist");
    }
  }
}

}  // namespace

void check(const ClashOptions& options) {
  if (options.within && !(std::isfinite(*options.within) && *options.within >= 0)) {
    throw Error(ErrorKind::usage,
                "within what distance parts are near is not a number of at least 0",
                "give a finite distance, or none");
  }
}

std::vector<PartNumbers> clash_candidates(std::span<const PartBody> a, std::span<const PartBody> b,
                                          const ClashOptions& options) {
  check(options);
  const PlainArithmetic plain;
  const double margin = options.within.value_or(0) / 2;
  std::vector<Box> boxes;
  boxes.reserve(a.size() + b.size());
  add_boxes(a, margin, boxes);
  add_boxes(b, margin, boxes);
  std::vector<std::uint32_t> side(a.size(), 1);
  side.resize(boxes.size(), 2);
  BroadPhase broad_phase;
  broad_phase.set_filter(std::move(side), {});
  return meeting(boxes, static_cast<std::uint32_t>(a.size()), broad_phase, options);
}

std::vector<PartNumbers> clash_candidates(std::span<const PartBody> parts,
                                          const ClashOptions& options) {
  check(options);
  const PlainArithmetic plain;
  std::vector<Box> boxes;
  boxes.reserve(parts.size());
  add_boxes(parts, options.within.value_or(0) / 2, boxes);
  BroadPhase broad_phase;
  return meeting(boxes, 0, broad_phase, options);
}

ClashList clashes_of(std::span<const PartBody> a, std::span<const PartBody> b,
                     std::span<const PartNumbers> pairs, const ClashOptions& options,
                     const Parallel& parallel) {
  check(options);
  check_numbers(a, b, pairs);
  std::vector<ClashList> pieces((pairs.size() + kPairsOfAChunk - 1) / kPairsOfAChunk);
  for_each_chunk(pairs.size(), kPairsOfAChunk, parallel, [&](std::size_t begin, std::size_t end) {
    const PlainArithmetic plain;
    ClashList& piece = pieces[begin / kPairsOfAChunk];
    PairOfParts decider(options, parallel);
    for (std::size_t k = begin; k < end; ++k) {
      std::optional<Clash> clash = decider.decide(a[pairs[k].first], b[pairs[k].second]);
      ++(decider.cut() ? piece.left_out : piece.compared);
      if (clash && !decider.cut()) {
        clash->a = pairs[k].first;
        clash->b = pairs[k].second;
        piece.clashes.push_back(*clash);
      }
    }
    piece.cost = decider.cost();
  });
  ClashList list;
  for (const ClashList& piece : pieces) {
    list.clashes.insert(list.clashes.end(), piece.clashes.begin(), piece.clashes.end());
    list.compared += piece.compared;
    list.left_out += piece.left_out;
    list.cost += piece.cost;
  }
  list.coverage = list.left_out == 0 ? Coverage::complete : Coverage::cut;
  return list;
}

ClashList clashes(std::span<const PartBody> a, std::span<const PartBody> b,
                  const ClashOptions& options, const Parallel& parallel) {
  return clashes_of(a, b, clash_candidates(a, b, options), options, parallel);
}

ClashList clashes(std::span<const PartBody> parts, const ClashOptions& options,
                  const Parallel& parallel) {
  return clashes_of(parts, parts, clash_candidates(parts, options), options, parallel);
}

}  // namespace soms
