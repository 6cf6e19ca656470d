#include "apps/store/probed_model.h"

#include "apps/model/shapes.h"

namespace soms::command {

ProbedModel::ProbedModel(const std::string& path, const ModelOptions& reading,
                         const BuildOptions& build, const Pose& pose,
                         const std::vector<RefusedOfTiles>& refused, const Console& console) {
  if (is_tile_folder(path)) {
    refuse_of_tiles(path, refused);
    tiles_ = TiledBody{open_tiles(path, reading, build, console), pose};
    mesh_ = tiles_->tiles.manifest().statements;
  } else {
    model_ = load_only_model(path, reading, {.build = build}, console);
    body_ = Body(model_.shape, pose);
    mesh_ = model_.file_mesh();
  }
}

}  // namespace soms::command
