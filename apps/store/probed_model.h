/// \file
/// The model of a question about points and rays: a shape, or a folder of tiles.
#pragma once

#include "soms/query/body.h"
#include "soms/tiles/tile_set.h"

#include "apps/model/file_numbers.h"
#include "apps/store/tiles.h"

#include <optional>
#include <string>
#include <vector>

namespace soms::command {

/// A model at its pose, read when it is made.
class ProbedModel {
 public:
  /// `refused` has no meaning where the model is a folder of tiles.
  /// \errors As `load_only_model` and `open_tiles`.
  ProbedModel(const std::string& path, const ModelOptions& reading, const BuildOptions& build,
              const Pose& pose, const std::vector<RefusedOfTiles>& refused, const Console& console);

  /// As the file is: triangles of answers have its numbers (`numbers`). Of tiles: what they state,
  /// without triangles.
  [[nodiscard]] const MeshView& mesh() const { return mesh_; }

  [[nodiscard]] const FileNumbers& numbers() const { return model_.numbers; }

  /// \pre The model is no folder of tiles.
  [[nodiscard]] const Body& body() const { return body_; }

  /// Calls `ask` with the body, or with the tiles.
  template <class Ask>
  void visit(const Ask& ask) const {
    if (tiles_) {
      ask(*tiles_);
    } else {
      ask(body_);
    }
  }

 private:
  std::optional<TiledBody> tiles_;
  ModelShape model_;
  Body body_;  ///< of what takes part
  MeshView mesh_;
};

}  // namespace soms::command
