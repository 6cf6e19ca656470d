#include "soms/tree/build_options.h"

#include "soms/base/error.h"
#include "soms/generate/urban.h"
#include "soms/tree/build.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/support.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

namespace soms {
namespace {

TEST(BuildOptions, DefaultsAndThesisOptionsAreInRange) {
  EXPECT_NO_THROW(check(BuildOptions{}));
  EXPECT_EQ(BuildOptions{}.level, 0);
  EXPECT_EQ(BuildOptions{}.per_leaf, 8);
  EXPECT_EQ(BuildOptions{}.empty_side, EmptySide::object_median);
  for (const Rule rule : {Rule::object_median, Rule::object_mean, Rule::spatial_median, Rule::soms,
                          Rule::sah, Rule::soms_sah}) {
    const BuildOptions options = thesis_options(rule);
    EXPECT_NO_THROW(check(options));
    EXPECT_EQ(options.rule, rule);
    EXPECT_EQ(options.midpoint, Midpoint::thesis);
    EXPECT_EQ(options.c_vertex, 2);
    EXPECT_FALSE(options.axis_from.has_value());
    EXPECT_EQ(options.empty_side, EmptySide::stop);
    EXPECT_EQ(options.level, 15);
    EXPECT_EQ(options.root_level, 1);
    EXPECT_EQ(options.per_leaf, 1);
  }
  EXPECT_EQ(thesis_options(Rule::soms, 13).level, 13);
}

TEST(BuildOptions, RefusesEachOptionOutOfRangeAndNamesIt) {
  struct Case {
    const char* named;
    std::function<void(BuildOptions&)> spoil;
  };

  const std::vector<Case> cases{
      {"rule", [](BuildOptions& o) { o.rule = static_cast<Rule>(rules().size()); }},
      {"midpoint", [](BuildOptions& o) { o.midpoint = static_cast<Midpoint>(-1); }},
      {"axis_from", [](BuildOptions& o) { o.axis_from = static_cast<AxisFrom>(2); }},
      {"empty_side", [](BuildOptions& o) { o.empty_side = static_cast<EmptySide>(4); }},
      {"c_vertex", [](BuildOptions& o) { o.c_vertex = 3; }},
      {"c_vertex", [](BuildOptions& o) { o.c_vertex = -1; }},
      {"root_level", [](BuildOptions& o) { o.root_level = 2; }},
      {"level", [](BuildOptions& o) { o.level = -1; }},
      {"level", [](BuildOptions& o) { o.level = 65; }},
      {"level", [](BuildOptions& o) { o.level = 64, o.root_level = 0; }},
      {"per_leaf", [](BuildOptions& o) { o.per_leaf = 0; }},
      {"chain", [](BuildOptions& o) { o.empty_side = EmptySide::chain; }},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.named);
    BuildOptions options;
    c.spoil(options);
    try {
      static_cast<void>(build(Mesh{}, options));
      ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_NE(std::string(error.what()).find(c.named), std::string::npos) << error.what();
    }
  }
}

/// What `build` says of options; empty where it takes them.
std::string refusal(const BuildOptions& options) {
  try {
    static_cast<void>(build(Mesh{}, options));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    return error.what();
  }
  return "";
}

TEST(BuildOptions, R119OptionsThatTheRuleIgnoresAreRefused) {
  for (const Rule rule : {Rule::fast, Rule::quality, Rule::quick}) {
    EXPECT_EQ(refusal({.rule = rule, .midpoint = Midpoint::centroid}),
              "build options: midpoint has no effect: the rules fast, quality and quick have "
              "builders of their own; leave it at its default, or choose another rule");
    EXPECT_NE(refusal({.rule = rule, .c_vertex = 1}).find("c_vertex has no effect"),
              std::string::npos);
    EXPECT_NE(refusal({.rule = rule, .axis_from = AxisFrom::inner}).find("axis_from has no effect"),
              std::string::npos);
    EXPECT_NE(refusal({.rule = rule, .empty_side = EmptySide::stop}).find("empty_side has no eff"),
              std::string::npos);
    EXPECT_EQ(refusal({.rule = rule, .level = 9, .root_level = 0, .per_leaf = 1}), "");
  }
  EXPECT_EQ(refusal({.rule = Rule::soms, .c_vertex = 0}),
            "build options: c_vertex has no effect: only the midpoint thesis has a corner C; leave "
            "it at its default, or set midpoint to thesis");
  EXPECT_EQ(refusal({.rule = Rule::soms, .root_level = 0}),
            "build options: root_level has no effect: levels are not limited; leave it at its "
            "default, or set level to N");
  EXPECT_EQ(refusal({.rule = Rule::soms,
                     .midpoint = Midpoint::thesis,
                     .c_vertex = 0,
                     .axis_from = AxisFrom::outer,
                     .empty_side = EmptySide::next_axis,
                     .level = 9,
                     .root_level = 0}),
            "");
}

// The table of the options that have no effect against the trees themselves: each option, set to
// another value beside the same others, changes a tree where the table says that it has an effect,
// and is refused where it says that it has none.
TEST(BuildOptions, R119AnOptionThatIsNotRefusedChangesATree) {
  struct Change {
    const char* name;
    void (*apply)(BuildOptions& options);
  };

  constexpr std::array<Change, 5> kChanges{{
      {"midpoint", [](BuildOptions& o) { o.midpoint = Midpoint::centroid; }},
      {"c_vertex", [](BuildOptions& o) { o.c_vertex = 0; }},
      {"axis_from", [](BuildOptions& o) { o.axis_from = AxisFrom::inner; }},
      {"empty_side", [](BuildOptions& o) { o.empty_side = EmptySide::next_axis; }},
      {"root_level", [](BuildOptions& o) { o.root_level = 0; }},
  }};
  const Mesh mesh = generate_urban(UrbanScene::mixed);
  for (const Rule rule : {Rule::spatial_median, Rule::fast, Rule::quality, Rule::quick}) {
    for (const Midpoint midpoint : {Midpoint::thesis, Midpoint::aabb}) {
      for (const int level : {0, 13}) {
        BuildOptions plain{.rule = rule, .midpoint = midpoint, .level = level, .per_leaf = 1};
        plain = without_idle(plain);
        const std::vector<IdleOption> idle = idle_options(plain);
        const Tree tree = build(mesh, plain);
        for (const Change& change : kChanges) {
          SCOPED_TRACE(std::string(entry(rule).name) + ' ' + change.name);
          BuildOptions changed = plain;
          change.apply(changed);
          const bool is_idle = std::any_of(idle.begin(), idle.end(), [&](const IdleOption& option) {
            return option.name == change.name;
          });
          if (is_idle) {
            EXPECT_NE(refusal(changed).find(std::string(change.name) + " has no effect"),
                      std::string::npos);
            EXPECT_EQ(without_idle(changed), plain);
          } else {
            EXPECT_FALSE(build(mesh, changed) == tree);
          }
        }
      }
    }
  }
}

TEST(BuildOptions, AcceptsTheEndsOfEachRange) {
  BuildOptions options;
  options.rule = Rule::soms;
  options.midpoint = Midpoint::thesis;
  options.level = 64;
  options.empty_side = EmptySide::chain;
  EXPECT_NO_THROW(check(options));
  options.root_level = 0;
  options.level = 63;
  options.c_vertex = 0;
  options.per_leaf = std::numeric_limits<int>::max();
  EXPECT_NO_THROW(check(options));
}

}  // namespace
}  // namespace soms
