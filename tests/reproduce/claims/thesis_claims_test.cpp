#include "thesis/claims/thesis_claims.h"

#include <gtest/gtest.h>

#include <set>

namespace soms::reproduce {
namespace {

TEST(ThesisClaims, EachRowSaysAllThatThePageHas) {
  std::set<std::string_view> ids;
  for (const ThesisClaim& claim : kThesisClaims) {
    EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
    for (const std::string_view text :
         {claim.statement, claim.source, claim.why_nearest, claim.settles}) {
      EXPECT_FALSE(text.empty()) << claim.id;
    }
    EXPECT_NE(words_of(claim.demands[0].demand), "") << claim.id << " demands nothing";
    const bool has_two = !words_of(claim.demands[1].demand).empty();
    EXPECT_EQ(has_two, !claim.demands[0].words.empty()) << claim.id << ": two demands have words";
    EXPECT_EQ(has_two, !claim.demands[1].words.empty()) << claim.id;
  }
}

TEST(ThesisClaims, AFigureIsJudgedOnItsModelAlone) {
  const ThesisClaim& figure = thesis_claim("balanced_level_7");
  ClaimRow row = counted_row("", "balanced level", "a scene", "", figure.demands[0].demand, 7);
  row.triangles = 5671;
  Claim claim = judged(figure, {row});
  EXPECT_EQ(claim.scope, Scope::figure);
  EXPECT_EQ(verdict_of(claim), Verdict::cannot_be_checked);
  row.triangles = 5672;
  EXPECT_EQ(verdict_of(judged(figure, {row})), Verdict::holds);
}

TEST(ThesisClaims, AComparisonIsJudgedOnEveryModel) {
  const ThesisClaim& comparison = thesis_claim("build_city");
  const ClaimRow row = counted_row("r", "m", "s", "%", comparison.demands[0].demand, 1);
  const Claim claim = judged(comparison, {row}, "level 7");
  EXPECT_EQ(claim.scope, Scope::comparison);
  EXPECT_EQ(claim.nearest, "level 7");
  EXPECT_EQ(verdict_of(claim), Verdict::holds);
  EXPECT_EQ(judged(thesis_claim("no_fallback"), {}).nearest, "stop, inner axis, midpoint thesis");
}

}  // namespace
}  // namespace soms::reproduce
