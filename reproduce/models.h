/// \file
/// The models that the experiments run on: files where they are given, else generated stand-ins
/// that say so.
#pragma once

#include "soms/base/parallel.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace soms::reproduce {

/// A model and where it came from.
struct Model {
  std::string name;   ///< as in the golden tables: "bunny", "u_mixed"; of a user's file its stem
  std::string title;  ///< for people: "Stanford bunny (bun_zipper_res4.ply)"
  std::string file = {};  ///< name of the file it was read from, without folder; empty if generated
  bool stand_in = false;  ///< not the model of the thesis but one made or put in its place
  std::string trouble = {};  ///< why the file of this model was not used; empty if all is well
  std::shared_ptr<const Mesh> mesh = {};  ///< never null
  std::uint64_t hash = 0;                 ///< FNV-1a 64 of all coordinates, triangle by triangle
};

/// All models of a run.
struct Models {
  /// The objects of the thesis: bunny, venus, teapot (two files are known by that name, both are
  /// run where both are given). The bunny is always the first.
  std::vector<Model> objects = {};
  /// The urban scenes: u_mixed, u_boxes, u_plain, written as .3ds and read back; or the .3ds files
  /// of the user in their place.
  std::vector<Model> scenes = {};
  /// Real cities of today, by size; may be empty.
  std::vector<Model> cities = {};
  /// Sentences about files that were not used and that no model's `trouble` tells of.
  std::vector<std::string> remarks = {};
};

/// Which models an experiment looks at.
struct Needs {
  bool objects = false;
  bool scenes = false;
  bool cities = false;
};

/// Finds the models. Looks in `folder` and its subfolders `ply`, `3ds` and `cities`; an empty path
/// means that all are generated. A file that is missing or cannot be read is named in
/// Model::trouble and a stand-in takes its place.
/// \errors ErrorKind::cannot_open if `folder` is given and is no folder; cancelled.
[[nodiscard]] Models find_models(const std::filesystem::path& folder, Needs needs,
                                 const Parallel& parallel = {});

}  // namespace soms::reproduce
