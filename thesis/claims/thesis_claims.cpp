#include "thesis/claims/thesis_claims.h"

#include <string>
#include <utility>

namespace soms::reproduce {

Claim judged(const ThesisClaim& claim, std::vector<ClaimRow> rows, std::string nearest) {
  Claim made{.id = std::string(claim.id),
             .statement = std::string(claim.statement),
             .source = std::string(claim.source),
             .rows = std::move(rows),
             .scope = claim.named_triangles > 0 ? Scope::figure : Scope::comparison,
             .named_triangles = claim.named_triangles,
             .nearest = nearest.empty() ? std::string(claim.nearest) : std::move(nearest),
             .why_nearest = std::string(claim.why_nearest),
             .settles = std::string(claim.settles)};
  judge_subjects(made);
  return made;
}

}  // namespace soms::reproduce
