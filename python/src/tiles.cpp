#include "soms/base/error.h"
#include "soms/tiles/cut_tiles.h"
#include "soms/tiles/tile_set.h"

#include "python/src/arrays.h"
#include "python/src/call.h"
#include "python/src/enums.h"
#include "python/src/paths.h"
#include "python/src/scene/bodies.h"
#include "python/src/text.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

namespace soms::python {

namespace {

constexpr const char* kTileSetDoc =
    R"(TileSet(folder, *, max_memory=None, check='sound')

A folder of tiles: models of more triangles than memory, which `soms tile` or cut_tiles cut. Tiles
are opened when a query meets them. overlap, distance and within take it as b, closest, closest_hit
and any_hit as body, with the answers of one shape of all triangles. It is pickled as its path.

folder: a path. max_memory: most bytes of tiles that are mapped at a time; None for no limit. check:
a name of TreeCheck, by which a tile is looked at when it is met first.

Raises Error of kind cannot_open, bad_file, unsupported.)";

constexpr const char* kCutDoc =
    R"(cut_tiles(folder, meshes, *, most=1000000, rule='fast', layout='wide', threads=1) -> TileSet

Cuts meshes into a folder of tiles, one after the other: with a generator only one is in memory.
Triangles are numbered through all of them. Meshes that an earlier call has cut are not cut again.

folder: a path; made unless it is there. meshes: Mesh, or objects with vertices and faces. most:
triangles of a tile. rule, layout: as of Shape. threads: 0 for all processors.

Raises Error of kind usage (meshes of several units, axes or places), cannot_write, out_of_range.)";

/// Sets of tiles that were unpickled last: the tasks of one process name the same few.
class OpenedSets {
 public:
  /// \errors ErrorKind::bad_file where the folder has other tiles since it was pickled.
  [[nodiscard]] TileSet get(const std::filesystem::path& folder, const TileOptions& options,
                            std::uint64_t hash) {
    const std::lock_guard lock(mutex_);
    const auto known = std::find_if(sets_.begin(), sets_.end(), [&](const TileSet& set) {
      return set.hash() == hash && set.folder() == folder && set.options() == options;
    });
    if (known != sets_.end()) {
      return *known;
    }
    TileSet set = TileSet::open(folder, options);
    if (set.hash() != hash) {
      throw Error(ErrorKind::bad_file, folder.string() + ": not the tiles that were pickled",
                  "open them again, and pickle that");
    }
    if (sets_.size() == kMost) {
      sets_.erase(sets_.begin());
    }
    sets_.push_back(set);
    return set;
  }

 private:
  static constexpr std::size_t kMost = 4;

  std::mutex mutex_;
  std::vector<TileSet> sets_;
};

TileOptions options_of(std::optional<std::uint64_t> max_memory, const py::object& check) {
  TileOptions options;
  options.check = enum_of<TreeCheck>(check, "check");
  if (max_memory) {
    options.max_memory = *max_memory;
  }
  return options;
}

TileSet opened_set(const py::object& folder, std::optional<std::uint64_t> max_memory,
                   const py::object& check) {
  const std::filesystem::path path = path_of(folder);
  const TileOptions options = options_of(max_memory, check);
  return run(Work::many, 1, py::none(),
             [&](const Limits&) { return TileSet::open(path, options); });
}

TileSet set_from(const py::tuple& state) {
  static OpenedSets sets;
  const std::filesystem::path folder(state[0].cast<Text>().bytes);
  TileOptions options;
  options.max_memory = state[1].cast<std::uint64_t>();
  options.check = enum_of<TreeCheck>(state[2], "check");
  const auto hash = state[3].cast<std::uint64_t>();
  return run(Work::many, 1, py::none(),
             [&](const Limits&) { return sets.get(folder, options, hash); });
}

py::tuple state_of(const TileSet& set) {
  return py::make_tuple(Text{set.place().string()}, set.options().max_memory,
                        member(set.options().check).attr("name"), set.hash());
}

TileSet cut_into(const py::object& folder, const py::iterable& meshes, std::size_t most,
                 const py::object& rule, const py::object& layout, int threads) {
  CutOptions options{.most = most};
  options.shape.build.rule = enum_of<Rule>(rule, "rule");
  options.shape.layout = enum_of<Layout>(layout, "layout");
  const std::filesystem::path path = path_of(folder);
  TileCutter cutter(path, options);
  for (const py::handle given : meshes) {
    const std::shared_ptr<const Mesh> mesh = mesh_of(given, "meshes");
    run(Work::many, threads, py::none(),
        [&](const Limits& limits) { return cutter.add(*mesh, limits); });
  }
  return run(Work::many, 1, py::none(), [&](const Limits&) {
    cutter.finish();
    return TileSet::open(path);
  });
}

}  // namespace

void bind_tiles(py::module_& module) {
  py::class_<TileSet> set(module, "TileSet", kTileSetDoc);
  set.def(py::init(&opened_set), py::arg("folder"), py::kw_only(),
          py::arg("max_memory") = py::none(), py::arg("check") = "sound");
  set.def_property_readonly(
      "folder", [](const TileSet& s) { return Text{s.folder().string()}; }, "Path of the folder.");
  set.def_property_readonly(
      "tiles", [](const TileSet& s) { return s.tiles().size(); }, "How many tiles there are.");
  set.def_property_readonly("bytes", &TileSet::bytes, "Bytes of all tiles.");
  set.def_property_readonly("openings", &TileSet::openings, "How often a tile was opened so far.");
  set.def_property_readonly(
      "bounds", [](const TileSet& s) { return array_of(s.bounds()); }, "(2, 3): of all triangles.");
  set.def_property_readonly(
      "georeference", [](const TileSet& s) { return s.manifest().statements.georeference; },
      "Georeference of all tiles.");
  set.def("hash", &TileSet::hash, "hash() -> int\n\nStands for the content of all tiles.");
  set.def("__len__", [](const TileSet& s) { return s.triangles(); });
  set.def(
      "__eq__", [](const TileSet& a, const TileSet& b) { return a == b; }, py::is_operator());
  set.attr("__hash__") = py::none();
  set.def("__repr__", [](const TileSet& s) {
    return Text{"TileSet('" + s.folder().string() + "', " + std::to_string(s.triangles()) +
                " triangles in " + std::to_string(s.tiles().size()) + " tiles)"};
  });
  set.def(py::pickle(&state_of, &set_from));
  module.def("cut_tiles", &cut_into, py::arg("folder"), py::arg("meshes"), py::kw_only(),
             py::arg("most") = CutOptions{}.most, py::arg("rule") = "fast",
             py::arg("layout") = "wide", py::arg("threads") = 1, kCutDoc);
}

}  // namespace soms::python
