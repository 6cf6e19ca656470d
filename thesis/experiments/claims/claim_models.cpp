// An object has 948 triangles, and the urban scene 5,672 (abstract).
//
// Two claims about files. A row for each model of that size, none of which can be judged: one that
// was generated was made to have the size, and one that was given was chosen for having it.
#include "thesis/claims/judged_subjects.h"
#include "thesis/experiments/experiments.h"

#include <utility>

namespace soms::reproduce {

namespace {

Claim claim_of(std::string id, std::string statement, std::span<const Model> models,
               std::size_t triangles) {
  Claim claim{.id = std::move(id),
              .statement = std::move(statement),
              .source = "abstract",
              .scope = Scope::figure,
              .named_triangles = triangles,
              .nearest = "triangles of the file",
              .why_nearest = "The count is all that the abstract says."};
  const auto size = static_cast<double>(triangles);
  for (const Model& model : models) {
    if (model.mesh->triangles.size() == triangles) {
      ClaimRow row = counted_row("triangles of the file", "triangles", {}, "",
                                 {.above = size - 0.5, .below = size + 0.5}, size);
      set_subject(row, model);
      row.unjudged = "it was chosen or made for having this count, so the count shows nothing";
      if (!model.stand_in) {
        claim.revision = Revision{Verdict::holds,
                                  "a model that was chosen for its count was taken to confirm it"};
      }
      claim.rows.push_back(std::move(row));
    }
  }
  judge_subjects(claim);
  return claim;
}

}  // namespace

Result claim_models(const Context& context) {
  Claim object = claim_of("object_948", "An object has 948 triangles", context.models.objects,
                          kObjectTriangles);
  object.why =
      "The thesis names the Stanford bunny and this count; of the four resolutions of the bunny in "
      "the Stanford repository bun_zipper_res4.ply is the one of 948 triangles. That one of them "
      "has the count speaks for this file as the object, and this program took it for that reason.";
  object.settles = "table 3.1 of the thesis, which says which object has which count";
  Claim scene = claim_of("scene_5672", "The urban scene has 5,672 triangles", context.models.scenes,
                         kSceneTriangles);
  scene.why = "The generated scenes were made to have this count.";
  scene.settles = "the scene of the thesis, which is not available";
  return {.claims = {std::move(object), std::move(scene)}};
}

}  // namespace soms::reproduce
