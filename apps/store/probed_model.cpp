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
    body_ = Body(load_shape(path, reading, {.build = build}, console), pose);
    mesh_ = body_.shape.mesh();
  }
}

}  // namespace soms::command
