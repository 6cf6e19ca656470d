#include "apps/soms/clash/clash_models.h"

#include "soms/base/error.h"
#include "soms/clash/part_keys.h"
#include "soms/geometry/parts_of.h"
#include "soms/io/formats.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/model/models.h"
#include "apps/model/part_filter.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>

namespace soms::command {

namespace {

namespace fs = std::filesystem;

/// Most parts of an open group that a row names beside the first.
constexpr std::size_t kMostNamed = 100;

/// What a folder has beside its models. Hidden files are passed over.
struct Strangers {
  std::vector<std::string> files;
  std::size_t subfolders = 0;
};

/// The note of what is not read.
std::string note_of(const std::string& folder, Strangers strangers) {
  std::string text;
  if (!strangers.files.empty()) {
    std::sort(strangers.files.begin(), strangers.files.end());
    const bool one = strangers.files.size() == 1;
    text = fmt::format("{} that {} ({}{})", counted(strangers.files.size(), "file"),
                       one ? "is not a model" : "are not models",
                       printable(strangers.files.front()), one ? "" : ", ...");
  }
  if (strangers.subfolders > 0) {
    text += (text.empty() ? "" : " and ") + counted(strangers.subfolders, "subfolder");
  }
  return fmt::format("{}: {} not read", printable(folder), text);
}

/// A link to what is not there: a model that is missing, and not a file of another kind.
bool is_broken_link(const fs::directory_entry& entry) {
  std::error_code unknown;
  return entry.is_symlink(unknown) && !entry.exists(unknown);
}

void add_models_in(const fs::path& folder, ModelFiles& models) {
  refuse_tiles(folder.string());
  std::vector<std::string> files;
  Strangers strangers;
  std::error_code fault;
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
       entry.increment(fault)) {
    std::error_code unknown;
    const std::string name = entry->path().filename().string();
    if (name.starts_with('.')) {
      continue;
    }
    if (entry->is_directory(unknown)) {
      ++strangers.subfolders;
    } else if ((entry->is_regular_file(unknown) || is_broken_link(*entry)) &&
               is_model_of_folder(entry->path())) {
      files.push_back(entry->path().string());
    } else {
      strangers.files.push_back(name);
    }
  }
  if (fault) {
    throw Error(ErrorKind::cannot_open, folder.string() + ": " + fault.message(),
                "give a folder that can be read");
  }
  if (files.empty()) {
    throw Error(ErrorKind::usage, folder.string() + ": a folder without models",
                "name models, or a folder that has some; soms version lists the formats");
  }
  std::sort(files.begin(), files.end());
  const auto tileset = std::find_if(files.begin(), files.end(), [](const std::string& file) {
    return fs::path(file).filename() == "tileset.json";
  });
  if (tileset != files.end()) {
    models.files.push_back(*tileset);  // the other files beside it are its tiles
    return;
  }
  models.files.insert(models.files.end(), files.begin(), files.end());
  if (strangers.subfolders > 0 || !strangers.files.empty()) {
    models.notes.push_back(note_of(folder.string(), std::move(strangers)));
  }
}

/// Where a model of a set is named twice, each of its parts would clash with itself.
void check_once(const std::vector<std::string>& files) {
  std::set<std::string> seen;
  for (const std::string& file : files) {
    std::error_code unknown;
    const fs::path whole = file == "-" ? fs::path(file) : fs::weakly_canonical(file, unknown);
    if (!seen.insert(unknown ? file : whole.string()).second) {
      throw Error(ErrorKind::usage, file + " is given twice", "give each model once");
    }
  }
}

void add_parts(Mesh mesh, ClashSet& set, Console& console) {
  std::vector<PartBody> parts =
      console.run("dividing " + printable(mesh.source) + " into parts",
                  [&](const Limits& limits) { return part_bodies(mesh, {}, limits); });
  set.mesh.insert(set.mesh.end(), parts.size(), static_cast<std::uint32_t>(set.meshes.size()));
  for (const PartBody& part : parts) {
    set.labels.push_back(body_label(mesh, part.part, part.joined));
  }
  std::move(parts.begin(), parts.end(), std::back_inserter(set.parts));
  set.meshes.push_back(std::move(mesh));
}

std::vector<NamedFrame> read_set(const std::vector<std::string>& files, const ModelOptions& options,
                                 const std::string& suffix, ClashSet& set, Console& console) {
  std::vector<NamedFrame> frames;
  for (const std::string& file : files) {
    Mesh mesh = read_model_of_set(file, options, console);
    frames.push_back(named_frame(mesh, options, "--scale" + suffix, "--up" + suffix));
    frames.back().is_shared = files.size() > 1;
    add_parts(std::move(mesh), set, console);
  }
  return frames;
}

/// Keys of both sets together, so that a name that both have is no key by itself.
void give_keys(ClashModels& models) {
  std::vector<MeshPart> named;
  for (ClashSet* const set : {&models.a, &models.b}) {
    for (std::uint32_t k = 0; k < set->parts.size(); ++k) {
      named.push_back({set->mesh_of(k), &set->parts[k]});
    }
  }
  const std::vector<std::uint64_t> keys = part_keys(named);
  const auto middle = keys.begin() + static_cast<std::ptrdiff_t>(models.a.parts.size());
  models.a.keys.assign(keys.begin(), middle);
  models.b.keys.assign(middle, keys.end());
}

Box box_of_set(const ClashSet& set) {
  Box box;
  for (const PartBody& part : set.parts) {
    box.grow(part.body.shape.bounds());
  }
  return box;
}

/// Two sets that are far apart may differ in their unit, axis or origin.
void doubt_gap(const ClashModelOptions& options, ClashModels& models) {
  BoxWatch boxes;
  boxes.look(box_of_set(models.a), box_of_set(models.b));
  if (models.two_sets && boxes.apart() && boxes.gap() > options.expected_gap) {
    models.warnings.push_back(
        apart_warning("the first set", "the set of --against", boxes.gap(), ""));
  }
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

/// The ends of the odd edges of a part that are named.
Json open_edges(const PartBody& part) {
  Json edges = Json::array();
  for (const EdgePlace& place : part.places) {
    const Triangle t = part.body.shape.mesh().triangle(place.triangle);
    const std::array<Vec3, 3> corners{t.a, t.b, t.c};
    const Vec3& from = corners[place.corner];
    const Vec3& to = corners[(place.corner + 1) % 3];
    edges.push_back({{from.x, from.y, from.z}, {to.x, to.y, to.z}});
  }
  return edges;
}

/// What a file says of a part: name, id, type, path, index.
Json named_side(const MeshView& mesh, std::uint32_t part) {
  if (part == Part::kNoParent) {
    return {{"part", nullptr},
            {"id", nullptr},
            {"type", nullptr},
            {"path", Json::array()},
            {"index", nullptr}};
  }
  return {{"part", mesh.parts[part].name},
          {"id", text_or_null(mesh.parts[part].id)},
          {"type", text_or_null(mesh.parts[part].type)},
          {"path", part_path(mesh, part)},
          {"index", part}};
}

}  // namespace

std::uint64_t ClashModels::pairs() const {
  const std::uint64_t n = a.parts.size();
  return two_sets ? n * b.parts.size() : n * (n - std::min<std::uint64_t>(n, 1)) / 2;
}

ModelFiles model_files(const std::vector<std::string>& names, const Console& console) {
  ModelFiles models;
  for (const std::string& name : names) {
    std::error_code unknown;
    if (fs::is_directory(name, unknown)) {
      add_models_in(name, models);
    } else {
      models.files.push_back(name);
    }
  }
  for (const std::string& note : models.notes) {
    console.note(note);
  }
  return models;
}

Mesh read_model_of_set(const std::string& file, const ModelOptions& options,
                       const Console& console) {
  Mesh mesh = read_model(file, options, console);
  const UpAxis up = mesh.up;
  if (options.up == UpAxis::unknown && (up == UpAxis::x || up == UpAxis::y)) {
    mesh = transformed(std::move(mesh), 1, up);
    console.note(fmt::format("{}: the file declares that {} is up; rotated to z",
                             printable(mesh.source), up == UpAxis::x ? "x" : "y"));
  }
  return options.parts ? options.parts->left(std::move(mesh)) : mesh;
}

ClashModels read_clash_models(const ClashModelOptions& options, Console& console) {
  ClashModels models;
  models.two_sets = !options.against.empty();
  const auto [files, notes] = model_files(options.files, console);
  const auto [against, notes_against] = model_files(options.against, console);
  std::vector<std::string> all = files;
  all.insert(all.end(), against.begin(), against.end());
  check_once(all);
  const std::vector<NamedFrame> frames = read_set(files, options.model, "", models.a, console);
  const std::vector<NamedFrame> frames_against =
      read_set(against, options.model_against, "-b", models.b, console);
  if (options.model.parts) {
    options.model.parts->finish(console);
  }
  give_keys(models);
  std::vector<MeshView> meshes;
  for (const ClashSet* const set : {&models.a, &models.b}) {
    meshes.insert(meshes.end(), set->meshes.begin(), set->meshes.end());
  }
  models.georeference = georeference_of(meshes);
  models.notes = notes;
  models.notes.insert(models.notes.end(), notes_against.begin(), notes_against.end());
  for (std::string& note : notes_of(meshes)) {
    models.notes.push_back(std::move(note));
  }
  models.warnings = world_warnings(frames, frames_against);
  doubt_gap(options, models);
  tell_warnings(models.warnings, options.model.strict, console);
  return models;
}

Json clash_side(const ClashSet& set, std::uint32_t number) {
  return clash_side(set, number, set.parts[number]);
}

Json clash_side(const ClashSet& set, std::uint32_t number, const PartBody& part) {
  const MeshView& mesh = set.mesh_of(number);
  Json side = {{"file", mesh.source}, {"set", set.sets[number]}};
  side.update(named_side(mesh, part.part));
  // A body that is closed has its parts for itself; an open group may be a side of many rows.
  const std::size_t named =
      &part == &set.parts[number] ? part.joined.size() : std::min(part.joined.size(), kMostNamed);
  for (std::size_t k = 0; k < named; ++k) {
    side["joined"].push_back(named_side(mesh, part.joined[k]));
  }
  if (named < part.joined.size()) {
    side["joined_more"] = part.joined.size() - named;
  }
  if (!part.closed) {
    side["odd_edges"] = part.odd_edges;
    side["open_at"] = open_edges(part);
  }
  return side;
}

}  // namespace soms::command
