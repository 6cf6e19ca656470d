/// \file
/// Which subjects a claim is judged on: one rule for stand-ins and one for toy sets, in every
/// claim.
///
/// A figure is judged only on the model that it names: one that was given and has as many
/// triangles. A comparison is judged on every model, stand-ins included, for it speaks of models in
/// general. Sets that this project made to show a picture are shown and never judged.
#pragma once

#include "thesis/claims/claim.h"
#include "thesis/trips/models.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace soms::reproduce {

/// Triangles of the object and of the urban scene that the figures of the thesis name.
/// \source thesis, abstract.
inline constexpr std::size_t kObjectTriangles = 948;
inline constexpr std::size_t kSceneTriangles = 5672;

/// Makes a model the subject of a row: its label, whether it is a stand-in, and its triangles.
/// `unjudged` says why the row is not judged; it is empty where it is.
[[nodiscard]] ClaimRow on_model(ClaimRow row, const Model& model, std::string_view unjudged = {});

/// The model of this number of triangles that is not known to be a stand-in: the first of `models`
/// that has it, or nullptr.
[[nodiscard]] const Model* named_model(std::span<const Model> models, std::size_t triangles);

/// Applies the rule to all rows that are judged so far, and marks those that it leaves out only
/// because their model is a stand-in.
void judge_subjects(Claim& claim);

}  // namespace soms::reproduce
