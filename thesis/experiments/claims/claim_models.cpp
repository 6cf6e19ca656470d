// An object has 948 triangles, and the urban scene 5,672 (abstract).
//
// Two claims about files. A row for each model of that size, none of which can be judged: one that
// was generated was made to have the size, and one that was given was chosen for having it.
#include "thesis/claims/thesis_claims.h"
#include "thesis/experiments/experiments.h"

#include <utility>

namespace soms::reproduce {

namespace {

Claim claim_of(const ThesisClaim& stated, std::span<const Model> models) {
  std::vector<ClaimRow> rows;
  bool was_given = false;
  for (const Model& model : models) {
    if (model.mesh->triangles.size() == stated.named_triangles) {
      rows.push_back(on_model(
          counted_row("triangles of the file", "triangles", {}, "", stated.demands[0].demand,
                      static_cast<double>(stated.named_triangles)),
          model, "it was chosen or made for having this count, so the count shows nothing"));
      was_given = was_given || !model.stand_in;
    }
  }
  Claim claim = judged(stated, std::move(rows));
  if (was_given) {
    claim.revision =
        Revision{Verdict::holds, "a model that was chosen for its count was taken to confirm it"};
  }
  return claim;
}

}  // namespace

Result claim_models(const Context& context) {
  Claim object = claim_of(thesis_claim("object_948"), context.models.objects);
  object.why =
      "The thesis names the Stanford bunny and this count; of the four resolutions of the bunny in "
      "the Stanford repository bun_zipper_res4.ply is the one of 948 triangles. That one of them "
      "has the count speaks for this file as the object, and this program took it for that reason.";
  Claim scene = claim_of(thesis_claim("scene_5672"), context.models.scenes);
  scene.why = "The generated scenes were made to have this count.";
  return {.claims = {std::move(object), std::move(scene)}};
}

}  // namespace soms::reproduce
