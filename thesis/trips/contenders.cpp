#include "thesis/trips/contenders.h"

#include "soms/tree/rule/rules.h"

namespace soms::reproduce {

namespace {

Contender thesis_rule(Rule rule, std::string title, int level) {
  return {std::string(entry(rule).name), std::move(title), true, thesis_options(rule, level)};
}

}  // namespace

std::vector<Contender> thesis_rules(int level) {
  return {thesis_rule(Rule::object_median, "object median", level),
          thesis_rule(Rule::object_mean, "object mean", level),
          thesis_rule(Rule::spatial_median, "spatial median", level),
          thesis_rule(Rule::soms, "SOMS", level)};
}

std::vector<Contender> all_builds(int level) {
  std::vector<Contender> builds = thesis_rules(level);
  builds.push_back(
      {"sah", "SAH", false, BuildOptions{.rule = Rule::sah, .level = level, .per_leaf = 1}});
  builds.push_back({"default", "library's default", false, BuildOptions{}});
  return builds;
}

}  // namespace soms::reproduce
