// An object has 948 triangles, and the urban scene 5,672 (abstract).
//
// Two claims about files. A row for each model of that size: a model that was given shows it, one
// that was generated to have the size shows nothing and is not judged.
#include "reproduce/counts.h"
#include "reproduce/experiments/experiments.h"
#include "reproduce/open_options.h"

#include <utility>

namespace soms::reproduce {

namespace {

Claim claim_of(std::string id, std::string statement, std::span<const Model> models,
               std::size_t triangles) {
  Claim claim{.id = std::move(id), .statement = std::move(statement), .source = "abstract"};
  const auto size = static_cast<double>(triangles);
  for (const Model& model : models) {
    if (model.mesh->triangles.size() == triangles) {
      ClaimRow row = counted_row("", "triangles", label_of(model), "",
                                 {.above = size - 1, .below = size + 1}, size);
      row.unjudged = not_of_thesis(model, triangles);
      claim.rows.push_back(std::move(row));
    }
  }
  return claim;
}

}  // namespace

Result claim_models(const Context& context) {
  Claim object = claim_of("object_948", "An object has 948 triangles", context.models.objects, 948);
  object.why =
      "The thesis names the Stanford bunny and this count; of the four resolutions of the bunny in "
      "the Stanford repository bun_zipper_res4.ply is the one of 948 triangles.";
  object.settles = "bun_zipper_res4.ply in the folder of --models";
  Claim scene =
      claim_of("scene_5672", "The urban scene has 5,672 triangles", context.models.scenes, 5672);
  scene.why = "The generated scenes were made to have this count.";
  scene.settles = "the scene of the thesis, as 3DS in the folder of --models";
  return {.claims = {std::move(object), std::move(scene)}};
}

}  // namespace soms::reproduce
