#include "thesis/trips/models.h"

#include "soms/base/arithmetic.h"
#include "soms/base/box.h"
#include "soms/base/error.h"
#include "soms/generate/urban.h"
#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"

#include "apps/output/sha256.h"
#include "thesis/trips/stand_ins.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <system_error>
#include <utility>

namespace soms::reproduce {

namespace {

namespace fs = std::filesystem;

double longest_edge(const Box& box) {
  const Vec3 extent = box.extent();
  return std::max({extent.x, extent.y, extent.z});
}

/// An object of the thesis, the file that it is known by, and what stands in for it.
struct KnownObject {
  std::string_view name;
  std::string_view title;
  std::string_view file;
  std::uint64_t hash = 0;  ///< of the model that the golden tables were made with
  std::string_view stand_in;
  Mesh (*make)() = nullptr;
};

constexpr std::string_view kSmallTeapot = "teapot_1177";
constexpr std::string_view kTeapot = "teapot";

constexpr std::array<KnownObject, 4> kKnownObjects = {{
    {"bunny", "Stanford bunny", "bun_zipper_res4.ply", 0x23e1390559ce62edULL,
     "a generated statue of 948 triangles", stand_in_bunny},
    {"venus", "Venus", "venus.ply", 0xb4c5b8d4374d26cdULL, "a generated statue of 1,416 triangles",
     stand_in_venus},
    {kSmallTeapot, "Teapot of 1,177 vertices", "teapot_1177.ply", 0x443d997a2f94d83aULL,
     "generated from Newell's patches", stand_in_small_teapot},
    {kTeapot, "Teapot", "teapot.ply", 0x3d13e5f55250fafcULL, "generated from Newell's patches",
     stand_in_teapot},
}};

struct KnownScene {
  std::string_view name;
  std::string_view title;
  UrbanScene scene = UrbanScene::mixed;
};

constexpr std::array<KnownScene, 3> kKnownScenes = {{
    {"u_mixed", "U-mixed", UrbanScene::mixed},
    {"u_boxes", "U-boxes", UrbanScene::boxes},
    {"u_plain", "U-plain", UrbanScene::plain},
}};

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) {
    text += part;
  }
  return text;
}

bool ends_with(const fs::path& path, std::string_view extension) {
  std::string found = path.extension().string();
  for (char& c : found) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return found == extension;
}

bool is_object(const fs::path& path) {
  return std::any_of(kKnownObjects.begin(), kKnownObjects.end(), [&](const KnownObject& object) {
    return path.filename().string() == object.file;
  });
}

std::optional<fs::file_time_type> last_change(const fs::path& path) {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(path, error);
  return error ? std::nullopt : std::optional(time);
}

void set_mesh(Model& model, Mesh mesh) {
  model.hash = corner_hash(mesh);
  model.mesh = std::make_shared<const Mesh>(std::move(mesh));
}

class Finder {
 public:
  Finder(const fs::path& folder, const Limits& limits) : folder_(folder), limits_(limits) {}

  Models find(Needs needs);

 private:
  /// Fills in mesh, hash and file. An empty answer, or why it was not possible.
  std::string read(const fs::path& path, Model& model);
  /// Where the file of an object is; empty if it is missing.
  [[nodiscard]] fs::path place_of(std::string_view file) const;
  Model object(const KnownObject& known);
  void find_objects();
  /// Files of a folder by their extension, sorted.
  [[nodiscard]] std::vector<fs::path> files_in(const fs::path& folder, std::string_view extension);
  /// The file's stem, numbered if a model has that name.
  std::string unused_name(const fs::path& path);
  /// Those that can be read; `trouble` tells of the others.
  std::vector<Model> read_all(const std::vector<fs::path>& files, std::string& trouble);
  [[nodiscard]] std::vector<fs::path> scene_files();
  Model generated_scene(const KnownScene& known);
  void find_scenes(const std::vector<fs::path>& files);
  [[nodiscard]] std::vector<fs::path> city_files();
  void find_cities(const std::vector<fs::path>& files);
  [[nodiscard]] Limits for_one() const;
  void step();

  const fs::path& folder_;
  const Limits& limits_;
  Models models_;
  std::set<std::string> names_;
  std::size_t done_ = 0;
  std::size_t all_ = 1;
};

/// For the work on one model: its progress is a part of the whole.
Limits Finder::for_one() const {
  Limits one = limits_.without_deadline().silent();
  if (limits_.progress) {
    one.progress = [this](double share) {
      limits_.progress(
          std::min(1.0, (static_cast<double>(done_) + share) / static_cast<double>(all_)));
    };
  }
  return one;
}

void Finder::step() {
  ++done_;
  check_stop(limits_);
}

std::string Finder::read(const fs::path& path, Model& model) {
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  if (fs::is_fifo(status) || fs::is_socket(status)) {
    return joined({path.string(), ": not a file"});  // opening it would wait for a writer
  }
  const auto before = last_change(path);
  try {
    set_mesh(model, read_mesh(path, {}, for_one()));
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled) {
      throw;
    }
    return error.what();
  }
  model.file = path.filename().string();
  model.sha256 = command::sha256_of_file(path);
  if (last_change(path) != before) {
    model.sha256.clear();  // perhaps of other bytes than those that were read
    models_.remarks.push_back(joined({path.string(), ": changed while it was read"}));
  }
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(path, error);
  model.bytes = error ? 0 : bytes;
  return {};
}

fs::path Finder::place_of(std::string_view file) const {
  for (const fs::path& place : {folder_ / file, folder_ / "ply" / file}) {
    std::error_code error;
    // A link that leads nowhere counts: the reader then tells of it.
    if (fs::exists(fs::symlink_status(place, error))) {
      return place;
    }
  }
  return {};
}

Model Finder::object(const KnownObject& known) {
  Model model;
  model.name = known.name;
  model.title = joined({known.title, " (", known.file, ")"});
  if (folder_.empty()) {
    model.trouble = "no folder of models was given";
  } else if (const fs::path place = place_of(known.file); place.empty()) {
    model.trouble = joined({known.file, " is not in ", folder_.string(), " or its folder ply"});
  } else {
    model.trouble = read(place, model);
    if (model.trouble.empty() && model.hash != known.hash) {
      models_.remarks.push_back(
          joined({place.string(), " does not have the triangles of the ", known.file,
                  " used here: its counts may differ from those expected"}));
    }
  }
  if (!model.mesh) {
    model.stand_in = true;
    model.title = joined({known.title, " (stand-in: ", known.stand_in, ")"});
    set_mesh(model, known.make());
  }
  return model;
}

void Finder::find_objects() {
  bool has_teapot = false;
  for (const KnownObject& known : kKnownObjects) {
    const bool given = !folder_.empty() && !place_of(known.file).empty();
    // Two files are known as the teapot: one that is missing is not missed when the other is there,
    // and one stand-in is enough.
    const bool wanted =
        known.name == kTeapot ? given || !has_teapot : given || known.name != kSmallTeapot;
    if (wanted) {
      models_.objects.push_back(object(known));
      has_teapot = has_teapot || known.name == kSmallTeapot;
    }
    step();
  }
}

std::vector<fs::path> Finder::files_in(const fs::path& folder, std::string_view extension) {
  std::vector<fs::path> files;
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    return files;
  }
  fs::directory_iterator at(folder, error);
  for (const fs::directory_iterator end; !error && at != end; at.increment(error)) {
    if (ends_with(at->path(), extension)) {
      files.push_back(at->path());
    }
  }
  if (error) {
    models_.remarks.push_back(joined({folder.string(), ": ", error.message()}));
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string Finder::unused_name(const fs::path& path) {
  const std::string stem = path.stem().string();
  std::string name = stem;
  for (int i = 2; !names_.insert(name).second; ++i) {
    name = stem + "_" + std::to_string(i);
  }
  return name;
}

std::vector<Model> Finder::read_all(const std::vector<fs::path>& files, std::string& trouble) {
  std::vector<Model> models;
  for (const fs::path& file : files) {
    Model model;
    const std::string why = read(file, model);
    if (why.empty()) {
      model.name = unused_name(file);
      model.title = model.file;
      models.push_back(std::move(model));
    } else {
      trouble += (trouble.empty() ? "" : "; ") + why;
    }
    step();
  }
  return models;
}

std::vector<fs::path> Finder::scene_files() {
  if (folder_.empty()) {
    return {};
  }
  std::vector<fs::path> files = files_in(folder_, ".3ds");
  const std::vector<fs::path> more = files_in(folder_ / "scenes", ".3ds");
  files.insert(files.end(), more.begin(), more.end());
  const fs::path beside = folder_ / "3ds";
  const std::size_t others = files.empty() ? files_in(beside, ".3ds").size() : 0;
  if (others != 0) {
    models_.remarks.push_back(joined({beside.string(), ": its .3ds files (", std::to_string(others),
                                      ") were not used as scenes; scenes are read from ",
                                      folder_.string(), " and its folder scenes"}));
  }
  return files;
}

std::string to_three_ds(const Mesh& mesh) {
  std::ostringstream out;
  write_mesh(out, "scene.3ds", mesh, MeshFormat::three_ds);
  return std::move(out).str();
}

Model Finder::generated_scene(const KnownScene& known) {
  const Mesh made = generate_urban(known.scene);
  const std::string file = to_three_ds(made);
  Model model;
  model.name = unused_name(known.name);
  model.title = joined({known.title, " (stand-in: generated, written as .3ds and read back)"});
  model.stand_in = true;
  model.bytes = file.size();
  model.sha256 = command::sha256(file);
  Mesh mesh =
      read_mesh(std::as_bytes(std::span(file)), joined({known.name, ".3ds"}), {}, for_one());
  mesh.up = made.up;  // 3DS keeps neither
  mesh.unit = made.unit;
  set_mesh(model, std::move(mesh));
  return model;
}

void Finder::find_scenes(const std::vector<fs::path>& files) {
  std::string trouble;
  models_.scenes = read_all(files, trouble);
  if (!models_.scenes.empty() && trouble.empty()) {
    return;
  }
  // Beside scenes of the user one is enough.
  const std::size_t wanted = models_.scenes.empty() ? kKnownScenes.size() : 1;
  for (std::size_t i = 0; i < wanted; ++i) {
    models_.scenes.push_back(generated_scene(kKnownScenes[i]));
    models_.scenes.back().trouble = trouble;
    step();
  }
}

std::vector<fs::path> Finder::city_files() {
  if (folder_.empty()) {
    return {};
  }
  std::vector<fs::path> others = files_in(folder_, ".ply");
  others.erase(std::remove_if(others.begin(), others.end(), is_object), others.end());
  if (!others.empty()) {
    models_.remarks.push_back(
        joined({folder_.string(), ": its other .ply files (", std::to_string(others.size()),
                ") were not used as cities; cities are read from its folder "
                "cities"}));
  }
  return files_in(folder_ / "cities", ".ply");
}

void Finder::find_cities(const std::vector<fs::path>& files) {
  std::string trouble;
  models_.cities = read_all(files, trouble);
  if (!trouble.empty()) {
    models_.remarks.push_back("cities that were not used: " + trouble);
  }
  std::stable_sort(models_.cities.begin(), models_.cities.end(),
                   [](const Model& a, const Model& b) {
                     return a.mesh->triangles.size() < b.mesh->triangles.size();
                   });
}

Models Finder::find(Needs needs) {
  std::error_code error;
  if (!folder_.empty() && !fs::is_directory(folder_, error)) {
    throw Error(ErrorKind::cannot_open,
                joined({folder_.string(), error ? ": " + error.message() : ": this is no folder"}),
                "give the folder of the models");
  }
  if (!folder_.empty()) {
    const fs::directory_iterator listed(folder_, error);
    if (error) {
      throw Error(ErrorKind::cannot_open, joined({folder_.string(), ": ", error.message()}),
                  "make the folder readable");
    }
  }
  check_stop(limits_);
  for (const KnownObject& known : kKnownObjects) {
    names_.emplace(known.name);
  }
  const std::vector<fs::path> scenes = needs.scenes ? scene_files() : std::vector<fs::path>();
  const std::vector<fs::path> cities = needs.cities ? city_files() : std::vector<fs::path>();
  all_ = (needs.objects ? kKnownObjects.size() : 0) +
         (needs.scenes ? scenes.size() + kKnownScenes.size() : 0) + cities.size() + 1;
  if (needs.objects) {
    find_objects();
    fit_drives(models_.objects);
  }
  if (needs.scenes) {
    find_scenes(scenes);
  }
  if (needs.cities) {
    find_cities(cities);
  }
  if (limits_.progress) {
    limits_.progress(1);
  }
  return std::move(models_);
}

}  // namespace

Mesh driven(const Model& object) {
  Mesh mesh = transformed(*object.mesh, object.drive.scale, UpAxis::y);
  if (object.drive.shift != Vec3{}) {
    for (Vec3& vertex : mesh.vertices) {
      vertex += object.drive.shift;
    }
  }
  return mesh;
}

void fit_drives(std::span<Model> objects) {
  const PlainArithmetic plain;
  for (std::size_t i = 1; i < objects.size(); ++i) {
    const Box first = bounds(*objects[0].mesh);
    const Box own = bounds(*objects[i].mesh);
    if (first.empty() || own.empty() || longest_edge(own) == 0) {
      continue;
    }
    DriveFit& drive = objects[i].drive;
    drive = {objects[0].drive.scale * longest_edge(first) / longest_edge(own), {}};
    const Box goal = bounds(driven(objects[0]));
    const Box large = bounds(driven(objects[i]));
    drive.shift = 0.5 * (goal.lower + goal.upper) - 0.5 * (large.lower + large.upper);
    drive.shift.z = goal.lower.z - large.lower.z;
  }
}

Models find_models(const fs::path& folder, Needs needs, const Limits& limits) {
  return Finder(folder, limits).find(needs);
}

std::string scene_file(const Model& scene) {
  return to_three_ds(*scene.mesh);
}

}  // namespace soms::reproduce
