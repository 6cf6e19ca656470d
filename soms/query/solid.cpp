#include "soms/query/solid.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/describe/columns.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/overlap_run.h"
#include "soms/query/detail/solid/solid_search.h"
#include "soms/query/overlap.h"

#include <utility>

namespace soms {

namespace {

using detail::FirstContact;

/// What threads need for a block of poses.
struct SolidMemory {
  detail::OverlapRun run;
  OverlapBatch found;
  std::vector<const Pose*> poses;
};

bool any_empty(const ClosedBody& a, const ClosedBody& b) {
  return detail::is_empty(a.body().shape) || detail::is_empty(b.body().shape);
}

/// The mover at a pose; nothing where it is not closed there.
std::optional<ClosedBody> placed(const ClosedBody& mover, const Pose& pose) {
  try {
    return mover.at(pose);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::not_closed) {
      throw;
    }
    return std::nullopt;
  }
}

/// Answers a block of poses: contacts of all first, then what else it takes for each.
void answer_block(const ClosedBody& mover, std::span<const Pose> poses, const ClosedBody& fixed,
                  const Limits& limits, std::size_t begin, SolidMemory& memory, SolidBatch& batch) {
  memory.poses.clear();
  for (const Pose& pose : poses) {
    memory.poses.push_back(&pose);
  }
  memory.run.ask(mover.body().shape, memory.poses, fixed.body(), {.mode = OverlapMode::any}, limits,
                 memory.found);
  const OverlapBatch& found = memory.found;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    FirstContact contact{.cut = found.coverage[i] == Coverage::cut, .cost = found.costs[i]};
    if (found.any[i] != 0) {
      contact.pair = found.pairs_of(i).front();
    }
    const std::optional<ClosedBody> a = placed(mover, poses[i]);
    put_columns(a ? detail::solid_relation(*a, fixed, contact, limits)
                  : Solid{.surfaces_meet = contact.pair.has_value(),
                          .why = Undecided::open,
                          .cost = contact.cost},
                begin + i, batch);
  }
}

}  // namespace

Solid solid(const ClosedBody& a, const ClosedBody& b, const Limits& limits) {
  const PlainArithmetic plain;
  check_stop(limits);
  if (any_empty(a, b)) {
    return {.relation = Relation::clear};
  }
  const Limits alone = limits.alone();
  const Overlap found = overlap(a.body(), b.body(), {.mode = OverlapMode::any}, alone);
  FirstContact contact{.cut = found.coverage == Coverage::cut, .cost = found.cost};
  if (found.any) {
    contact.pair = found.pairs.front();
  }
  return detail::solid_relation(a, b, contact, limits);
}

Solid solid(const Body& a, const Body& b, const Limits& limits) {
  const Limits silent = limits.silent().without_deadline();
  return solid(ClosedBody(a, silent), ClosedBody(b, silent), limits);
}

Solid SolidBatch::at(std::size_t pose) const {
  return row_of<Solid>(*this, pose);
}

SolidBatch solid(const ClosedBody& mover, std::span<const Pose> poses, const ClosedBody& fixed,
                 const Limits& limits) {
  const PlainArithmetic plain;
  SolidBatch batch;
  detail::check_poses(poses, mover.body().shape);
  resize_columns<Solid>(batch, poses.size());
  if (any_empty(mover, fixed)) {
    batch.relation.assign(poses.size(), Relation::clear);
    return batch;
  }
  const Limits alone = limits.alone();
  detail::for_each_block(
      poses.size(), limits, [] { return SolidMemory(); },
      [&](SolidMemory& memory, std::size_t begin, std::size_t end) {
        answer_block(mover, poses.subspan(begin, end - begin), fixed, alone, begin, memory, batch);
      });
  sum_costs<Solid>(batch);
  return batch;
}

SolidBatch solid(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                 const Limits& limits) {
  const Limits silent = limits.silent().without_deadline();
  return solid(ClosedBody(Body(mover), silent), poses, ClosedBody(fixed, silent), limits);
}

}  // namespace soms
