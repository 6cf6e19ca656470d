#include "thesis/run/counts.h"

#include "soms/base/assert.h"
#include "soms/tree/build.h"
#include "soms/tree/option_names.h"
#include "soms/tree/rule/rules.h"

#include "thesis/run/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace soms::reproduce {

namespace {

/// A column that a table of builds may have.
struct Field {
  std::string_view name;
  std::string_view unit;
  Cell (*cell)(const Counted& row);
};

Cell whole_cell(std::uint64_t value) {
  return static_cast<std::int64_t>(value);
}

Cell word(std::string_view value) {
  return std::string(value);
}

Cell percent_cell(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? Cell{} : Cell{100 * static_cast<double>(part) / static_cast<double>(whole)};
}

Cell limit(int level) {
  return level == 0 ? Cell{} : Cell{std::int64_t{level}};
}

AxisFrom axis_of(const BuildOptions& options) {
  return options.axis_from.value_or(entry(options.rule).axis_from);
}

/// Greatest balanced level that the number of triangles and the limit of levels allow.
std::uint64_t possible_level(const Counted& counted) {
  const auto level =
      static_cast<std::uint64_t>(std::bit_width(counted.model->mesh->triangles.size()));
  const BuildOptions& options = counted.contender.options;
  const int limit = options.level + 1 - options.root_level;
  return options.level == 0 ? level : std::min(level, static_cast<std::uint64_t>(limit));
}

/// Which corner is C matters to the midpoint of the thesis only.
Cell c_vertex(const BuildOptions& options) {
  return options.midpoint == Midpoint::thesis ? Cell{std::int64_t{options.c_vertex}} : Cell{};
}

constexpr std::array kFields{
    Field{"model", "", [](const Counted& r) { return word(r.model->name); }},
    Field{"origin", "",
          [](const Counted& r) { return word(r.model->stand_in ? "stand-in" : r.model->file); }},
    Field{"triangles", "",
          [](const Counted& r) { return whole_cell(r.model->mesh->triangles.size()); }},
    Field{"rule", "", [](const Counted& r) { return word(r.contender.name); }},
    Field{"midpoint", "",
          [](const Counted& r) { return word(name(r.contender.options.midpoint)); }},
    Field{"c_vertex", "", [](const Counted& r) { return c_vertex(r.contender.options); }},
    Field{"axis_from", "",
          [](const Counted& r) { return word(name(axis_of(r.contender.options))); }},
    Field{"empty_side", "",
          [](const Counted& r) { return word(name(r.contender.options.empty_side)); }},
    Field{"root_level", "",
          [](const Counted& r) { return Cell{std::int64_t{r.contender.options.root_level}}; }},
    Field{"level", "", [](const Counted& r) { return limit(r.contender.options.level); }},
    Field{"per_leaf", "",
          [](const Counted& r) { return Cell{std::int64_t{r.contender.options.per_leaf}}; }},
    Field{"nodes", "", [](const Counted& r) { return whole_cell(r.counts.nodes); }},
    Field{"leaves", "", [](const Counted& r) { return whole_cell(r.counts.leaves); }},
    Field{"one", "", [](const Counted& r) { return whole_cell(r.counts.one); }},
    Field{"lt5", "", [](const Counted& r) { return whole_cell(r.counts.lt5); }},
    Field{"undividable", "", [](const Counted& r) { return whole_cell(r.counts.undividable); }},
    Field{"capped", "", [](const Counted& r) { return whole_cell(r.counts.capped); }},
    Field{"empty", "", [](const Counted& r) { return whole_cell(r.counts.empty); }},
    Field{"depth", "", [](const Counted& r) { return whole_cell(r.counts.depth); }},
    Field{"min_leaf_depth", "",
          [](const Counted& r) { return whole_cell(r.counts.min_leaf_depth); }},
    Field{"max_leaf_depth", "",
          [](const Counted& r) { return whole_cell(r.counts.max_leaf_depth); }},
    Field{"largest_leaf", "", [](const Counted& r) { return whole_cell(r.counts.largest_leaf); }},
    Field{"balanced_level", "",
          [](const Counted& r) { return whole_cell(r.counts.balanced_level); }},
    Field{"possible_level", "", [](const Counted& r) { return whole_cell(possible_level(r)); }},
    Field{"one_percent", "%",
          [](const Counted& r) {
            return percent_cell(r.counts.one, r.model->mesh->triangles.size());
          }},
    Field{"lt5_percent", "%",
          [](const Counted& r) { return percent_cell(r.counts.lt5, r.counts.leaves); }},
};

const Field& field_named(std::string_view name) {
  const auto* const found = std::find_if(kFields.begin(), kFields.end(),
                                         [&](const Field& field) { return field.name == name; });
  SOMS_ASSERT(found != kFields.end());
  return *found;
}

}  // namespace

Counted count(const Model& model, const Contender& contender, const Limits& limits) {
  const Tree tree =
      build(*model.mesh, contender.options, {.threads = limits.threads, .stop = limits.stop});
  return {&model, contender, statistics(tree, contender.options)};
}

std::vector<Counted> count_all(std::span<const Model> models, std::span<const Contender> contenders,
                               const Limits& limits) {
  Steps steps(limits, models.size() * contenders.size());
  std::vector<Counted> result;
  for (const Model& model : models) {
    for (const Contender& contender : contenders) {
      result.push_back(count(model, contender, steps.quiet()));
      steps.done_one();
    }
  }
  return result;
}

std::vector<Contender> at_every_level(int level, std::vector<Contender> (*builds)(int)) {
  std::vector<Contender> result;
  for (int at = 1; at <= level; ++at) {
    for (Contender& contender : builds(at)) {
      if (contender.options.level == at || at == level) {
        result.push_back(std::move(contender));
      }
    }
  }
  return result;
}

Contender with(Contender contender, EmptySide empty_side) {
  static constexpr std::array<std::string_view, 4> kWords{"stop", "next axis", "by median",
                                                          "chain"};
  if (contender.options.empty_side == empty_side) {
    return contender;
  }
  contender.options.empty_side = empty_side;
  contender.title += fmt::format(", {}", kWords.at(static_cast<std::size_t>(empty_side)));
  return contender;
}

Contender with(Contender contender, AxisFrom axis_from) {
  if (axis_of(contender.options) != axis_from) {
    contender.options.axis_from = axis_from;
    contender.title += fmt::format(", {} axis", name(axis_from));
  }
  return contender;
}

std::vector<Contender> all_builds_and_axes(int level) {
  std::vector<Contender> result;
  for (const Contender& contender : all_builds(level)) {
    result.push_back(contender);
    if (contender.of_thesis && contender.options.rule == Rule::soms) {
      result.push_back(with(contender, AxisFrom::outer));
    }
  }
  return result;
}

std::vector<Contender> with_each(std::span<const Contender> builds,
                                 std::span<const EmptySide> empty_sides) {
  std::vector<Contender> result;
  for (const Contender& contender : builds) {
    if (!contender.of_thesis || contender.options.rule == Rule::object_median) {
      result.push_back(contender);
      continue;
    }
    for (const EmptySide empty_side : empty_sides) {
      result.push_back(with(contender, empty_side));
    }
  }
  return result;
}

const Counted* find_count(std::span<const Counted> counts, const Model& model,
                          const BuildOptions& options) {
  const auto found = std::find_if(counts.begin(), counts.end(), [&](const Counted& one) {
    return one.model == &model && one.contender.of_thesis && one.contender.options == options;
  });
  return found == counts.end() ? nullptr : &*found;
}

int balanced_level(const Model& model, const Contender& contender, const Limits& limits) {
  return std::max(1, static_cast<int>(count(model, contender, limits).counts.balanced_level));
}

std::vector<Column> columns_of(std::span<const std::string_view> names) {
  std::vector<Column> columns;
  for (const std::string_view name : names) {
    columns.push_back({std::string(name), std::string(field_named(name).unit)});
  }
  return columns;
}

std::vector<Cell> cells_of(const Counted& counted, std::span<const std::string_view> names) {
  std::vector<Cell> cells;
  for (const std::string_view name : names) {
    cells.push_back(field_named(name).cell(counted));
  }
  return cells;
}

Table count_table(std::string id, std::string caption, std::span<const std::string_view> names,
                  std::span<const Counted> rows) {
  Table table{std::move(id), std::move(caption), columns_of(names), {}};
  for (const Counted& row : rows) {
    table.rows.push_back(cells_of(row, names));
  }
  return table;
}

std::string note_on_stand_ins(std::span<const Model> models) {
  std::string names;
  for (const Model& model : models) {
    if (model.stand_in) {
      names += fmt::format("{}{}", names.empty() ? "" : ", ", model.name);
    }
  }
  return names.empty() ? "" : fmt::format(" Stand-ins: {}.", names);
}

bool has_usual_options(const Contender& contender) {
  const BuildOptions& options = contender.options;
  return !contender.of_thesis || options == thesis_options(options.rule, options.level);
}

std::string words(std::uint64_t value) {
  return to_text(Cell{static_cast<std::int64_t>(value)});
}

std::string compare(std::uint64_t value, std::uint64_t base) {
  if (base == 0) {
    return fmt::format("{} to 0", words(value));
  }
  const double more = 100 * (static_cast<double>(value) / static_cast<double>(base) - 1);
  return fmt::format("{} to {} ({:+.0f} %)", words(value), words(base), more);
}

std::string label_of(const Model& model) {
  return model.stand_in ? model.name + " (stand-in)" : model.name;
}

std::string short_title(const Model& model) {
  return model.title.empty() ? model.name : model.title.substr(0, model.title.find(" ("));
}

}  // namespace soms::reproduce
