#include "soms/tree/build_options.h"

#include "soms/base/error.h"
#include "soms/tree/build.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/support.h"

#include <functional>
#include <string>

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

TEST(BuildOptions, AcceptsTheEndsOfEachRange) {
  BuildOptions options;
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
