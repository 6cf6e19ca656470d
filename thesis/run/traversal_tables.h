/// \file
/// Columns, cells and sentences that the experiments about traversals share.
#pragma once

#include "thesis/run/result.h"
#include "thesis/trips/frames.h"
#include "thesis/trips/models.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// A count as a cell.
[[nodiscard]] Cell count_cell(std::uint64_t count);

/// A measured number as a cell.
[[nodiscard]] Cell number_cell(double number);

/// Words as a cell.
[[nodiscard]] Cell word_cell(std::string_view words);

/// "yes" or "no".
[[nodiscard]] Cell yes_cell(bool yes);

/// The build with this name. \pre `builds` has it.
[[nodiscard]] const Contender& build_named(std::span<const Contender> builds,
                                           std::string_view name);

/// Appends the columns of all counters of a traversal, named as in the golden tables.
void add_count_columns(Table& table);

/// Appends the cells of those columns.
void add_count_cells(std::vector<Cell>& row, const TraversalCounts& counts);

/// Appends mean, median, min and max of numbers as columns that differ from run to run.
void add_statistics_columns(Table& table);

/// Appends the cells of those columns; empty ones where there are no numbers.
void add_statistics_cells(std::vector<Cell>& row, const std::vector<double>& numbers);

/// Frames a second where one takes so many `milliseconds`; empty where that is 0. For mean
/// times only: a mean of the rates of single frames would weigh short frames most.
[[nodiscard]] Cell rate_cell(double milliseconds);

/// Appends to the columns of `add_statistics_columns` the frames a second of the mean, median,
/// longest and shortest frame; empty cells where there are no numbers.
void add_rate_cells(std::vector<Cell>& row, const std::vector<double>& milliseconds);

/// Appends the median of rounds and the ends of its interval of 95 % as columns that differ from
/// run to run.
void add_estimate_columns(Table& table, std::string_view unit);

/// Appends the cells of those columns; empty ones where there are no rounds. So many processes
/// measured them.
void add_estimate_cells(std::vector<Cell>& row, std::span<const double> rounds, int processes);

/// Medians of the timings of those timed frames in which the roots overlap.
[[nodiscard]] std::vector<double> medians_where_roots_overlap(std::span<const Timing> timings,
                                                              std::span<const Frame> frames);

/// A model's name where it may be part of an id (snake_case), else "modelN" by its number.
[[nodiscard]] std::string id_word(std::string_view name, std::size_t number);

/// Mean of numbers; 0 of none.
[[nodiscard]] double mean_of(std::span<const double> numbers);

/// "The moving object is ...": names an object, and says so where it is a stand-in.
[[nodiscard]] std::string object_remark(const Model& object);

/// Sentences of `object_remark` for all objects, and how they drive.
[[nodiscard]] std::vector<std::string> object_remarks(std::span<const Model> objects);

/// Sentences that say what a scene is and that it stands in for the scene of the thesis.
[[nodiscard]] std::vector<std::string> scene_remarks(std::span<const Model> scenes);

/// Ends the run where answers that must agree do not; `what` names them.
/// \errors std::logic_error: a fault of the library, never of the input.
void require(bool agree, std::string_view what);

}  // namespace soms::reproduce
