/// \file
/// Trees that were built and counted, as rows of tables: the part that all tables of chapter 5
/// share.
#pragma once

#include "soms/base/limits.h"
#include "soms/tree/statistics.h"

#include "thesis/run/result.h"
#include "thesis/trips/contenders.h"
#include "thesis/trips/levels.h"
#include "thesis/trips/models.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// A build of a model's tree and what it counted.
struct Counted {
  const Model* model = nullptr;
  Contender contender = {};
  TreeStatistics counts = {};
};

/// Builds and counts. \errors ErrorKind::cancelled.
[[nodiscard]] Counted count(const Model& model, const Contender& contender, const Limits& limits);

/// Builds and counts every contender on every model, model by model, and reports progress.
[[nodiscard]] std::vector<Counted> count_all(std::span<const Model> models,
                                             std::span<const Contender> contenders,
                                             const Limits& limits);

/// Contenders of all levels from 1 to `level` in ascending order; those without a limit of levels
/// once, at the end. \pre `builds(l)` gives the same contenders for each level but for the level.
[[nodiscard]] std::vector<Contender> at_every_level(int level,
                                                    std::vector<Contender> (*builds)(int));

/// The contender with another option; its name stays, its title tells of the option if it changed.
[[nodiscard]] Contender with(Contender contender, EmptySide empty_side);
[[nodiscard]] Contender with(Contender contender, AxisFrom axis_from);

/// All builds of a level, and SOMS with the axis of the outer box besides.
[[nodiscard]] std::vector<Contender> all_builds_and_axes(int level);

/// The builds, those of the thesis once for each of these empty sides. Object median, which never
/// leaves a side empty, and builds that are not of the thesis stay as they are.
[[nodiscard]] std::vector<Contender> with_each(std::span<const Contender> builds,
                                               std::span<const EmptySide> empty_sides);

/// The build of a model by a rule of the thesis and these options; nullptr if there is none.
[[nodiscard]] const Counted* find_count(std::span<const Counted> counts, const Model& model,
                                        const BuildOptions& options);

/// The balanced level of a contender's tree on a model; 1 for an empty model.
[[nodiscard]] int balanced_level(const Model& model, const Contender& contender,
                                 const Limits& limits);

/// Cells of a build by the columns' names, all counted: model, origin, triangles, rule, midpoint,
/// c_vertex, axis_from, empty_side, root_level, level, per_leaf (what was built; the level is empty
/// where there is no limit), the counts of TreeStatistics by their names, possible_level (the
/// greatest balanced level that so many triangles allow), and the shares one_percent (triangles
/// alone in a leaf of all triangles) and lt5_percent (of all leaves).
/// \pre every name is one of these.
[[nodiscard]] std::vector<Column> columns_of(std::span<const std::string_view> names);
[[nodiscard]] std::vector<Cell> cells_of(const Counted& counted,
                                         std::span<const std::string_view> names);

/// A row for each build. The caption ends with a note on models that stand in for others.
[[nodiscard]] Table count_table(std::string id, std::string caption,
                                std::span<const std::string_view> names,
                                std::span<const Counted> rows);

/// " Stand-ins: u_mixed, u_boxes, u_plain." for the models that are; empty if none is.
[[nodiscard]] std::string note_on_stand_ins(std::span<const Model> models);

/// True for builds of the thesis with its options, and for all builds that are not of the thesis.
[[nodiscard]] bool has_usual_options(const Contender& contender);

/// A number with thousands apart: "5,672", for sentences.
[[nodiscard]] std::string words(std::uint64_t value);

/// "904 to 423 (+114 %)", for sentences.
[[nodiscard]] std::string compare(std::uint64_t value, std::uint64_t base);

/// The model's name, marked if it is a stand-in; for charts and sentences.
[[nodiscard]] std::string label_of(const Model& model);

/// The model's title without what stands in brackets; its name if it has no title.
[[nodiscard]] std::string short_title(const Model& model);

}  // namespace soms::reproduce
