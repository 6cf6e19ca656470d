/// \file
/// A single overlap query, on one thread or several.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/overlap.h"

namespace soms::detail {

/// Answers in `answer`, which is empty before. `Frame` is a PairFrame or a SelfFrame.
/// \errors ErrorKind::cancelled.
template <class Frame>
void search_overlap(Frame& frame, const OverlapOptions& options, const Limits& limits,
                    Overlap& answer);

}  // namespace soms::detail
