#include "thesis/claims/judged_subjects.h"

#include "thesis/run/counts.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::reproduce {

namespace {

/// Why a row decides nothing by what its subject is; empty if it does.
std::string reason_of(const Claim& claim, const ClaimRow& row) {
  if (row.kind == SubjectKind::toy_set) {
    return "a set that was made for a picture shows what it was made to show";
  }
  if (claim.scope == Scope::comparison) {
    return {};
  }
  if (row.kind == SubjectKind::stand_in) {
    return fmt::format(
        "the thesis' own model of {} triangles was not given, and a stand-in shows nothing about "
        "it",
        words(claim.named_triangles));
  }
  return row.triangles == claim.named_triangles
             ? std::string()
             : fmt::format("the claim is about a model of {} triangles, and this has {}",
                           words(claim.named_triangles), words(row.triangles));
}

}  // namespace

ClaimRow on_model(ClaimRow row, const Model& model, std::string_view unjudged) {
  row.subject = label_of(model);
  row.kind = model.stand_in ? SubjectKind::stand_in : SubjectKind::given;
  row.triangles = model.mesh->triangles.size();
  row.unjudged = unjudged;
  return row;
}

const Model* named_model(std::span<const Model> models, std::size_t triangles) {
  const auto found = std::find_if(models.begin(), models.end(), [&](const Model& model) {
    return !model.stand_in && model.mesh->triangles.size() == triangles;
  });
  return found == models.end() ? nullptr : &*found;
}

void judge_subjects(Claim& claim) {
  for (ClaimRow& row : claim.rows) {
    if (row.unjudged.empty()) {
      row.unjudged = reason_of(claim, row);
      row.on_stand_in = !row.unjudged.empty() && row.kind == SubjectKind::stand_in;
    }
  }
}

}  // namespace soms::reproduce
