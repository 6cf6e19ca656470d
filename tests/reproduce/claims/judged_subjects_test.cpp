// One rule for stand-ins and one for toy sets: by itself, and in every claim.
#include "thesis/claims/judged_subjects.h"

#include "soms/generate/shapes.h"

#include "tests/reproduce/trips.h"
#include "tests/support/slow_build.h"
#include "thesis/claims/nearest_verdict.h"
#include "thesis/run/experiment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {
namespace {

constexpr std::size_t kNamed = 948;

Model model_of(std::uint64_t triangles, bool stand_in) {
  Model model{.name = "knot", .title = "a test's", .stand_in = stand_in};
  model.mesh = std::make_shared<const Mesh>(generate_knot(triangles));
  return model;
}

ClaimRow row_on(const Model& model, std::string_view own_reason = {}) {
  return on_model(counted_row("stop", "leaves", {}, "", {.above = 0}, 1), model, own_reason);
}

Claim judged_claim(Scope scope, std::vector<ClaimRow> rows) {
  Claim claim{.id = "c",
              .statement = "More",
              .source = "abstract",
              .rows = std::move(rows),
              .scope = scope,
              .named_triangles = kNamed};
  judge_subjects(claim);
  return claim;
}

TEST(JudgedSubjects, AFigureIsJudgedOnlyOnTheModelThatItNames) {
  const Claim claim =
      judged_claim(Scope::figure, {row_on(model_of(kNamed, false)), row_on(model_of(60, false)),
                                   row_on(model_of(kNamed, true)),
                                   row_on(model_of(kNamed, true), "the outer axis")});
  EXPECT_EQ(claim.rows[0].unjudged, "");
  EXPECT_EQ(claim.rows[1].unjudged, "the claim is about a model of 948 triangles, and this has 60");
  EXPECT_EQ(claim.rows[2].unjudged,
            "the thesis' own model of 948 triangles was not given, and a stand-in shows nothing "
            "about it");
  EXPECT_EQ(claim.rows[2].subject, "knot (stand-in)");
  EXPECT_EQ(claim.rows[3].unjudged, "the outer axis");
  for (const std::size_t i : {0U, 1U, 3U}) {
    EXPECT_FALSE(claim.rows[i].on_stand_in) << i;
  }
  EXPECT_TRUE(claim.rows[2].on_stand_in);
  EXPECT_EQ(on_stand_ins(claim).rows, 1U);
  EXPECT_EQ(on_stand_ins(claim).hold, 1U);
  EXPECT_EQ(stand_in_words(claim), "On stand-ins, which decide nothing: 1 of 1 rows would hold.");
}

TEST(JudgedSubjects, AComparisonIsJudgedOnEveryModel) {
  const Claim claim = judged_claim(Scope::comparison,
                                   {row_on(model_of(kNamed, false)), row_on(model_of(60, true))});
  for (const ClaimRow& row : claim.rows) {
    EXPECT_EQ(row.unjudged, "");
    EXPECT_FALSE(row.on_stand_in);
  }
  EXPECT_EQ(stand_in_words(claim), "");
}

TEST(JudgedSubjects, ToySetsAreNeverJudged) {
  for (const Scope scope : {Scope::comparison, Scope::figure}) {
    ClaimRow toy = row_on(model_of(kNamed, false));
    toy.kind = SubjectKind::toy_set;
    const Claim claim = judged_claim(scope, {toy});
    EXPECT_EQ(claim.rows[0].unjudged,
              "a set that was made for a picture shows what it was made to show");
    EXPECT_FALSE(claim.rows[0].on_stand_in);
  }
}

TEST(JudgedSubjects, TheNamedModelIsGivenAndHasItsTriangles) {
  const std::vector<Model> models{model_of(kNamed, true), model_of(60, false),
                                  model_of(kNamed, false)};
  EXPECT_EQ(named_model(models, kNamed), &models[2]);
  EXPECT_EQ(named_model(models, 5672), nullptr);
}

std::vector<std::string_view> claim_items() {
  std::vector<std::string_view> items;
  for (const Experiment& experiment : experiments()) {
    if (experiment.chapter == Chapter::claims) {
      items.push_back(experiment.item);
    }
  }
  return items;
}

class EveryClaim : public testing::TestWithParam<std::string_view> {};

TEST_P(EveryClaim, KeepsToOneRuleOfStandInsAndOneOfToySets) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  for (const Claim& claim : trips::run_quick(GetParam(), trips::small_models()).claims) {
    const auto judged = [](const ClaimRow& row) { return row.unjudged.empty(); };
    EXPECT_EQ(std::any_of(claim.rows.begin(), claim.rows.end(), judged),
              claim.scope == Scope::comparison)
        << claim.id;
    EXPECT_EQ(claim.named_triangles > 0, claim.scope == Scope::figure) << claim.id;
    for (const ClaimRow& row : claim.rows) {
      EXPECT_FALSE(row.kind == SubjectKind::toy_set && row.unjudged.empty()) << row.subject;
      EXPECT_FALSE(row.on_stand_in && row.unjudged.empty()) << row.subject;
      EXPECT_FALSE(row.on_stand_in && claim.scope == Scope::comparison) << row.subject;
    }
  }
}

TEST_P(EveryClaim, HasANearestReadingWithAReason) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  for (const Claim& claim : trips::run_quick(GetParam(), trips::small_models()).claims) {
    EXPECT_FALSE(claim.nearest.empty()) << claim.id;
    EXPECT_TRUE(claim.why_nearest.ends_with('.')) << claim.id;
    EXPECT_EQ(claim.rows.empty(),
              std::none_of(claim.rows.begin(), claim.rows.end(),
                           [&](const ClaimRow& row) { return is_nearest(claim, row); }))
        << claim.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Reproduce, EveryClaim, testing::ValuesIn(claim_items()),
                         [](const auto& test) {
                           std::string name(test.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace soms::reproduce
