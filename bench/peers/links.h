/// \file
/// Questions about an arm, whose links are bodies of their own.
#pragma once

#include "bench/peers/libraries/library.h"

#include <memory>
#include <span>

namespace soms::bench {

/// Answers questions about all movers of a body by a match for each of them, in turn: a sum of
/// counts, or for `any` whether one touches, where the first that does ends a question. With
/// `batches` each match is queried once, about all questions that are still open.
void answer_links(std::span<const std::unique_ptr<Match>> matches, const Questions& questions,
                  bool batches, std::span<double> answers);

}  // namespace soms::bench
