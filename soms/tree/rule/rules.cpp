#include "soms/tree/rule/rules.h"

#include "soms/base/error.h"

#include <algorithm>
#include <array>
#include <string>

namespace soms {

namespace {

constexpr std::array kRules{
    RuleEntry{Rule::object_median, "object_median", "object-median",
              "equal counts on both sides, by midpoint", &rule::object_median, AxisFrom::outer,
              false, false, false},
    RuleEntry{Rule::object_mean, "object_mean", "object-mean", "plane at the mean of the midpoints",
              &rule::object_mean, AxisFrom::outer, false, true, false},
    RuleEntry{Rule::spatial_median, "spatial_median", "spatial-median",
              "plane in the middle of the outer box", &rule::spatial_median, AxisFrom::outer, true,
              false, false},
    RuleEntry{Rule::soms, "soms", "soms",
              "plane in the middle of the midpoints' box (the thesis' rule)", &rule::soms,
              AxisFrom::inner, false, false, false},
    RuleEntry{Rule::sah, "sah", "sah", "least surface area cost over 16 bins of the midpoints' box",
              &rule::sah, AxisFrom::inner, false, false, false},
    RuleEntry{Rule::soms_sah, "soms_sah", "soms-sah",
              "as soms where triangles are small against the node, else as sah", &rule::soms_sah,
              AxisFrom::inner, false, false, false},
    RuleEntry{Rule::fast, "fast", "fast",
              "as soms-sah, by boxes in float: builds fastest with leaves of 8", &rule::soms_sah,
              AxisFrom::inner, false, false, true},
    RuleEntry{Rule::quality, "quality", "quality",
              "as sah, by boxes in float and blocks of leaves: enters the fewest boxes", &rule::sah,
              AxisFrom::inner, false, false, true},
    RuleEntry{Rule::quick, "quick", "quick",
              "by Morton codes, large triangles apart: builds soonest, for meshes that change",
              &rule::soms, AxisFrom::inner, false, false, true},
};

constexpr bool in_order_of_enumeration() {
  for (std::size_t i = 0; i < kRules.size(); ++i) {
    if (kRules[i].rule != static_cast<Rule>(i)) {
      return false;
    }
  }
  return true;
}

// `entry` finds rows by their place.
static_assert(in_order_of_enumeration());

}  // namespace

std::span<const RuleEntry> rules() {
  return kRules;
}

const RuleEntry& entry(Rule rule) {
  return kRules[static_cast<std::size_t>(rule)];
}

const RuleEntry& rule_named(std::string_view name) {
  const auto* const row = std::find_if(kRules.begin(), kRules.end(), [&](const RuleEntry& e) {
    return e.name == name || e.kebab == name;
  });
  if (row == kRules.end()) {
    std::string names;
    for (const RuleEntry& e : kRules) {
      names += (names.empty() ? "" : ", ") + std::string(e.kebab);
    }
    throw Error(ErrorKind::usage, "no rule is named \"" + std::string(name) + "\"",
                "choose one of " + names);
  }
  return *row;
}

}  // namespace soms
