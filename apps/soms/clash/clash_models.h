/// \file
/// The models of `clash`, by their parts.
#pragma once

#include "soms/clash/part_bodies.h"
#include "soms/geometry/mesh.h"

#include "apps/model/frame_warnings.h"
#include "apps/model/models.h"
#include "apps/output/json.h"

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace soms::command {

class Console;

/// The parts of one or several models.
struct ClashSet {
  std::vector<Mesh> meshes;
  std::vector<PartBody> parts;      ///< of all meshes
  std::vector<std::uint32_t> mesh;  ///< of each part
  std::vector<std::uint64_t> keys;  ///< of each part
  std::vector<std::string> labels;  ///< of each part: its path of names
  std::vector<std::string> sets;    ///< of each part: the name of its set
  /// Of each part that leads an open group (PartBody::together): the sets of all its parts.
  std::map<std::uint32_t, std::set<std::string>> sets_of_groups;

  [[nodiscard]] const Mesh& mesh_of(std::uint32_t part) const { return meshes[mesh[part]]; }
};

/// What `clash` compares: a set with itself, or two sets.
struct ClashModels {
  ClashSet a;
  ClashSet b;  ///< empty: `a` is compared with itself
  bool two_sets = false;
  std::vector<FrameWarning> warnings;
  std::vector<std::string> notes;

  Georeference georeference;  ///< of coordinates in answers

  [[nodiscard]] const ClashSet& second() const { return two_sets ? b : a; }

  /// Pairs of parts that there are.
  [[nodiscard]] std::uint64_t pairs() const;
};

/// How the models of `clash` are named and read.
struct ClashModelOptions {
  std::vector<std::string> files;
  std::vector<std::string> against;
  ModelOptions model;
  ModelOptions model_against;
  double expected_gap = 0;  ///< sets that are farther apart are doubtful
};

/// Models that were named, each alone or by its folder.
struct ModelFiles {
  std::vector<std::string> files;
  std::vector<std::string> notes;  ///< what folders have besides; printed already
};

/// The models among `names`, where a folder stands for the models in it, by name; one with a
/// tileset.json stands for that. Other files and subfolders are not read, which a note says; hidden
/// ones are passed over.
/// \errors ErrorKind::usage for a folder without models; cannot_open for one that cannot be read.
[[nodiscard]] ModelFiles model_files(const std::vector<std::string>& names, const Console& console);

/// Reads the models and divides them into parts. A model whose file says that x or y is up is
/// turned to z up, unless an option says how it is to be turned.
/// \errors As `read_model`; ErrorKind::usage where a model is named twice.
[[nodiscard]] ClashModels read_clash_models(const ClashModelOptions& options, Console& console);

/// Reads a model of a set, turned to z up where its file says that x or y is, unless an option says
/// how it is to be turned; without the parts that options leave out.
/// \errors As `read_model`.
[[nodiscard]] Mesh read_model_of_set(const std::string& file, const ModelOptions& options,
                                     const Console& console);

/// A part as a side of a clash: file, name, id, type, path, index, the other parts of its body, and
/// where it is open.
[[nodiscard]] Json clash_side(const ClashSet& set, std::uint32_t part);

/// The same of `body`, which the part stands for (`body_in`).
[[nodiscard]] Json clash_side(const ClashSet& set, std::uint32_t part, const PartBody& body);

}  // namespace soms::command
