/// \file
/// The models that the experiments run on: files where they are given, else generated stand-ins
/// that say so.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// How many times as large as its file the first object drives through a city.
inline constexpr double kDriveScale = 500;

/// How an object drives through a scene: turned z up, enlarged, then moved.
struct DriveFit {
  double scale = kDriveScale;
  Vec3 shift = {};

  [[nodiscard]] bool operator==(const DriveFit&) const = default;
};

/// A model and where it came from.
struct Model {
  std::string name;   ///< as in the golden tables: "bunny", "u_mixed"; of a user's file its stem
  std::string title;  ///< for people: "Stanford bunny (bun_zipper_res4.ply)"
  std::string file = {};  ///< name of the file it was read from, without folder; empty if generated
  bool stand_in = false;  ///< not the model of the thesis but one made in its place
  std::string trouble = {};  ///< why the file of this model was not used; empty if all is well
  std::shared_ptr<const Mesh> mesh = {};  ///< never null
  std::uint64_t hash = 0;                 ///< FNV-1a 64 of all coordinates, triangle by triangle
  std::uint64_t bytes = 0;  ///< size of its file, of a generated scene that of its .3ds; or 0
  /// SHA-256 of the same bytes; empty if there are none, or the file changed while it was read
  std::string sha256 = {};
  DriveFit drive = {};  ///< of objects
};

/// The object as it drives: turned z up, enlarged and moved.
[[nodiscard]] Mesh driven(const Model& object);

/// Fits the drives of all objects but the first to that of the first, whose path is fixed: enlarged
/// until the longest edges of the boxes are equal, then moved until the boxes have one center in
/// plan and one underside. Files have units of their own: at one scale a teapot would be larger
/// than the city. Objects without vertices stay as they are.
/// \source ours. The thesis says of one object only that it drives.
void fit_drives(std::span<Model> objects);

/// All models of a run. No two have one name.
struct Models {
  /// The objects of the thesis: bunny, venus, teapot (two files are known by that name, both are
  /// run where both are given). The bunny is always the first.
  std::vector<Model> objects = {};
  /// The urban scenes, each read from .3ds: u_mixed, u_boxes, u_plain, bit for bit those of the
  /// golden tables; or the scenes of the user in their place.
  std::vector<Model> scenes = {};
  /// Real cities of today, by number of triangles; may be empty.
  std::vector<Model> cities = {};
  /// Sentences about files that were not used, or are not what their name says, and that no model's
  /// `trouble` tells of.
  std::vector<std::string> remarks = {};
};

/// Which models an experiment looks at.
struct Needs {
  bool objects = false;
  bool scenes = false;
  bool cities = false;
};

/// Where `find_models` looks, for the help.
inline constexpr std::string_view kModelsHelp =
    "Models in the folder of --models:\n"
    "  objects   bun_zipper_res4.ply, venus.ply, teapot_1177.ply, teapot.ply,\n"
    "            there or in its folder ply\n"
    "  scenes    all .3ds files there or in its folder scenes\n"
    "  cities    all .ply files in its folder cities\n"
    "A missing object and the scenes are generated, and the page says so.\n";

/// Finds the models.
///
/// Objects are read from the files of their names in `folder` or its subfolder `ply`. Scenes are
/// all .3ds files of `folder` and of its subfolder `scenes`; other subfolders may hold anything and
/// are left alone, which a remark tells of `3ds`. Cities are all .ply files of the subfolder
/// `cities`; a remark tells of those of `folder` that are no objects. An empty path means that all
/// is generated.
///
/// A file that is missing or cannot be read is named in Model::trouble of the stand-in that takes
/// its place (of two teapots one may be missing; for scenes of the user that cannot be read u_mixed
/// stands in, or all three if none can). Cities have no stand-ins: a remark tells. The generated
/// scenes are written as .3ds, in memory, and read from that.
/// \errors ErrorKind::cannot_open if `folder` is given and is no folder; cancelled.
[[nodiscard]] Models find_models(const std::filesystem::path& folder, Needs needs,
                                 const Limits& limits = {});

/// The .3ds file of a scene, the same bytes that a generated one was read from.
/// \errors Those of `write_mesh`.
[[nodiscard]] std::string scene_file(const Model& scene);

}  // namespace soms::reproduce
