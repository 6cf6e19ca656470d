/// \file
/// What a simulation tells of passages: for people, for programs, and as rows.
#pragma once

#include "apps/output/json.h"
#include "apps/soms/simulate/simulate_report.h"
#include "apps/soms/simulate/simulate_run.h"
#include "apps/world/world.h"

#include <ostream>
#include <string>
#include <string_view>

namespace soms::command {

/// Columns of the events that follow all others, where steps are swept.
inline constexpr std::string_view kPassageColumns =
    ",verdict,t_lower,t_upper,passing_triangle,passed_triangle";

/// Their fields in the row of another event.
inline constexpr std::string_view kPassageFieldsOfOthers = ",,,,,";

/// A line on how many there are, and lines on the first ones.
void add_passage_figures(Figures& figures, const World& world, const Outcome& outcome);

/// "12 passages and 34 pairs without one by brute force, 0 wrong"
[[nodiscard]] std::string passages_verified(const VerifiedPassages& verified);

/// The figures as members of the answer.
void add_passage_json(Json& json, const World& world, const Outcome& outcome);

/// Rows of events, behind all others. `empty` stands in the columns between.
void write_passages(std::ostream& out, const World& world, const Outcome& outcome,
                    std::string_view empty);

}  // namespace soms::command
