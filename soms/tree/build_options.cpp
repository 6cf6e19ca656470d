#include "soms/tree/build_options.h"

#include "soms/base/error.h"
#include "soms/tree/tree.h"

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

}  // namespace

BuildOptions thesis_options(Rule rule, int level) {
  BuildOptions options;
  options.rule = rule;
  options.midpoint = Midpoint::thesis;
  options.empty_side = EmptySide::stop;
  options.level = level;
  options.per_leaf = 1;
  return options;
}

void check(const BuildOptions& options) {
  require(within(options.rule, Rule::quality), "rule is none of the named ones", "name a rule");
  require(within(options.midpoint, Midpoint::aabb), "midpoint is none of the named ones",
          "use thesis, centroid or aabb");
  require(!options.axis_from || within(*options.axis_from, AxisFrom::inner),
          "axis_from is none of the named ones", "use outer or inner");
  require(within(options.empty_side, EmptySide::chain), "empty_side is none of the named ones",
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
          "empty_side chain without a level limit would not end", "give a level");
}

}  // namespace soms
