#include "soms/tree/build_options.h"

#include "soms/base/error.h"
#include "soms/tree/rule/rules.h"
#include "soms/tree/tree.h"

#include <array>
#include <string>

namespace soms {

namespace {

void require(bool holds, const std::string& place, const std::string& remedy) {
  if (!holds) {
    throw Error(ErrorKind::usage, "build options: " + place, remedy);
  }
}

template <class Enum>
bool within(Enum value, Enum last) {
  return static_cast<int>(value) >= 0 && static_cast<int>(value) <= static_cast<int>(last);
}

/// The one place that says which options of a build have an effect beside which others.
struct Row {
  IdleOption idle;
  bool (*has_no_effect)(const BuildOptions& options);
  bool (*is_set)(const BuildOptions& options);
  void (*reset)(BuildOptions& options);
};

bool own_builder(const BuildOptions& options) {
  return entry(options.rule).own_builder;
}

constexpr std::string_view kOwnBuilder =
    "the rules fast, quality and quick have builders of their own";

constexpr std::array<Row, 6> kRows{{
    {{"midpoint", kOwnBuilder, "rule", ""},
     &own_builder,
     [](const BuildOptions& o) { return o.midpoint != BuildOptions{}.midpoint; },
     [](BuildOptions& o) { o.midpoint = BuildOptions{}.midpoint; }},
    {{"c_vertex", kOwnBuilder, "rule", ""},
     &own_builder,
     [](const BuildOptions& o) { return o.c_vertex != BuildOptions{}.c_vertex; },
     [](BuildOptions& o) { o.c_vertex = BuildOptions{}.c_vertex; }},
    {{"c_vertex", "only the midpoint thesis has a corner C", "midpoint", "thesis"},
     [](const BuildOptions& o) { return !own_builder(o) && o.midpoint != Midpoint::thesis; },
     [](const BuildOptions& o) { return o.c_vertex != BuildOptions{}.c_vertex; },
     [](BuildOptions& o) { o.c_vertex = BuildOptions{}.c_vertex; }},
    {{"axis_from", kOwnBuilder, "rule", ""},
     &own_builder,
     [](const BuildOptions& o) { return o.axis_from.has_value(); },
     [](BuildOptions& o) { o.axis_from.reset(); }},
    {{"empty_side", "the rules fast, quality and quick leave no side empty", "rule", ""},
     &own_builder,
     [](const BuildOptions& o) { return o.empty_side != BuildOptions{}.empty_side; },
     [](BuildOptions& o) { o.empty_side = BuildOptions{}.empty_side; }},
    {{"root_level", "levels are not limited", "level", "N"},
     [](const BuildOptions& o) { return o.level == 0; },
     [](const BuildOptions& o) { return o.root_level != BuildOptions{}.root_level; },
     [](BuildOptions& o) { o.root_level = BuildOptions{}.root_level; }},
}};

void check_rule(Rule rule) {
  require(static_cast<std::size_t>(rule) < rules().size(), "unknown rule",
          "use one of the rules in Rule");
}

}  // namespace

std::vector<IdleOption> idle_options(const BuildOptions& options) {
  check_rule(options.rule);
  std::vector<IdleOption> idle;
  for (const Row& row : kRows) {
    if (row.has_no_effect(options)) {
      idle.push_back(row.idle);
    }
  }
  return idle;
}

BuildOptions without_idle(BuildOptions options) {
  check_rule(options.rule);
  for (const Row& row : kRows) {
    if (row.has_no_effect(options)) {
      row.reset(options);
    }
  }
  return options;
}

BuildOptions thesis_options(Rule rule, int level) {
  BuildOptions options;
  options.rule = rule;
  options.midpoint = Midpoint::thesis;
  options.empty_side = EmptySide::stop;
  options.level = level;
  options.per_leaf = 1;
  return without_idle(options);
}

void check(const BuildOptions& options) {
  check_rule(options.rule);
  require(within(options.midpoint, Midpoint::aabb), "unknown midpoint",
          "use thesis, centroid or aabb");
  require(!options.axis_from || within(*options.axis_from, AxisFrom::inner), "unknown axis_from",
          "use outer or inner");
  require(within(options.empty_side, EmptySide::chain), "unknown empty_side",
          "use stop, next_axis, object_median or chain");
  require(options.c_vertex >= 0 && options.c_vertex <= 2,
          "c_vertex is " + std::to_string(options.c_vertex), "use 0, 1 or 2");
  require(options.root_level == 0 || options.root_level == 1,
          "root_level is " + std::to_string(options.root_level), "use 0 or 1");
  const int last_level = kMaxTreeIdDepth + options.root_level;
  require(options.level >= 0 && options.level <= last_level,
          "level is " + std::to_string(options.level),
          "use 0 (no limit) to " + std::to_string(last_level));
  require(options.per_leaf >= 1, "per_leaf is " + std::to_string(options.per_leaf),
          "use 1 or more");
  require(options.empty_side != EmptySide::chain || options.level > 0,
          "empty_side chain without a limit of levels never ends", "set level");
  for (const Row& row : kRows) {
    if (row.is_set(options) && row.has_no_effect(options)) {
      refuse_idle("build options", row.idle);
    }
  }
}

}  // namespace soms
