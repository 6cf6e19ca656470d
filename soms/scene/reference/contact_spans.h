/// \file
/// Spans of contacts from all reports at once: what `ContactSpans` must equal.
#pragma once

#include "soms/scene/contact_spans.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soms::reference {

/// What `ContactSpans::follow` is given.
struct ContactStep {
  std::uint64_t step = 0;
  StepReport report;
  ContactBodies bodies;
};

/// The spans of these steps: every two sides that ever touch are looked up in every step.
/// \pre   Numbers of steps ascend, and the reports are complete.
/// \cost  O(s n log n), s pairs of sides and n contacts of all steps.
[[nodiscard]] std::vector<ContactSpan> contact_spans(std::span<const ContactStep> steps);

}  // namespace soms::reference
