#include "reproduce/models.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/generate/urban.h"
#include "soms/io/read_mesh.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

namespace soms::reproduce {

namespace {

namespace fs = std::filesystem;

/// An object of the thesis, the file that it is known by, and what stands in for it.
struct KnownObject {
  std::string_view name;
  std::string_view title;
  std::string_view file;
  std::string_view stand_in;
  Mesh (*make)();
};

/// The last two are both called teapot; one is enough.
constexpr std::array<KnownObject, 4> kObjects = {{
    {"bunny", "Stanford bunny", "bun_zipper_res4.ply", "a knot of 948 triangles",
     [] { return generate_knot(948); }},
    {"venus", "Venus", "venus.ply", "a knot of 1,416 triangles",
     [] { return generate_knot(1416); }},
    {"teapot_1177", "Teapot of 1,177 vertices", "teapot_1177.ply", "a sphere of 2,256 triangles",
     [] { return generate_sphere(2256); }},
    {"teapot", "Teapot", "teapot.ply", "a sphere of 6,320 triangles",
     [] { return generate_sphere(6320); }},
}};

struct KnownScene {
  std::string_view name;
  std::string_view title;
  UrbanScene scene;
};

constexpr std::array<KnownScene, 3> kScenes = {{
    {"u_mixed", "U-mixed", UrbanScene::mixed},
    {"u_boxes", "U-boxes", UrbanScene::boxes},
    {"u_plain", "U-plain", UrbanScene::plain},
}};

std::string lower(std::string text) {
  for (char& c : text) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error) && !fs::is_directory(path, error);
}

/// Finds models and counts what it has done, for progress.
class Finder {
 public:
  Finder(const fs::path& folder, const Parallel& parallel) : folder_(folder), parallel_(parallel) {}

  Models find(Needs needs);

 private:
  /// Fills in mesh and hash. An empty answer, or why it was not possible.
  std::string read(const fs::path& path, Model& model);
  void make(Mesh mesh, Model& model);
  /// The file in the folder or its subfolder `ply`; empty if there is none.
  [[nodiscard]] fs::path place_of(std::string_view file) const;
  Model object(const KnownObject& known);
  [[nodiscard]] std::vector<fs::path> files_in(const fs::path& folder,
                                               std::string_view ending) const;
  std::string unused_name(const fs::path& path);
  /// Those that can be read; `trouble` tells of the others.
  std::vector<Model> read_all(const std::vector<fs::path>& files, std::string& trouble);
  Model generated_scene(const KnownScene& known);
  void step();
  void find_objects();
  void find_scenes();
  void find_cities();

  const fs::path& folder_;
  const Parallel& parallel_;
  Models models_;
  std::set<std::string> names_;
  std::size_t done_ = 0;
};

void Finder::make(Mesh mesh, Model& model) {
  model.hash = corner_hash(mesh);
  model.mesh = std::make_shared<const Mesh>(std::move(mesh));
}

std::string Finder::read(const fs::path& path, Model& model) {
  Parallel quiet;
  quiet.stop = parallel_.stop;
  try {
    make(read_mesh(path, {}, quiet), model);
    model.file = path.filename().string();
    return {};
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled) {
      throw;
    }
    return error.what();
  }
}

fs::path Finder::place_of(std::string_view file) const {
  for (const fs::path& place : {folder_ / file, folder_ / "ply" / file}) {
    if (is_file(place)) {
      return place;
    }
  }
  return {};
}

Model Finder::object(const KnownObject& known) {
  Model model;
  model.name = known.name;
  model.title = std::string(known.title) + " (" + std::string(known.file) + ")";
  if (folder_.empty()) {
    model.trouble = "no folder of models was given";
  } else if (const fs::path place = place_of(known.file); place.empty()) {
    model.trouble = std::string(known.file) + " is not in " + folder_.string();
  } else {
    model.trouble = read(place, model);
  }
  if (!model.mesh) {
    model.stand_in = true;
    model.title = std::string(known.title) + " (stand-in: " + std::string(known.stand_in) + ")";
    make(known.make(), model);
  }
  return model;
}

void Finder::find_objects() {
  bool has_teapot = false;
  for (const KnownObject& known : kObjects) {
    const bool given = !folder_.empty() && !place_of(known.file).empty();
    const bool teapot = known.title.starts_with("Teapot");
    // Two files are known as the teapot: one that is missing is none when the other is there, and
    // one stand-in is enough.
    if (!teapot || given || (known.name == "teapot" && !has_teapot)) {
      models_.objects.push_back(object(known));
      step();
      has_teapot = has_teapot || teapot;
    }
  }
}

std::vector<fs::path> Finder::files_in(const fs::path& folder, std::string_view ending) const {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    const bool known = std::any_of(kObjects.begin(), kObjects.end(),
                                   [&](const KnownObject& object) { return object.file == name; });
    if (!known && lower(it->path().extension().string()) == ending && is_file(it->path())) {
      files.push_back(it->path());
    }
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

Model Finder::generated_scene(const KnownScene& known) {
  Model model;
  model.name = known.name;
  model.title = std::string(known.title) + " (stand-in, generated)";
  model.stand_in = true;
  make(generate_urban(known.scene), model);
  step();
  return model;
}

void Finder::find_scenes() {
  std::vector<fs::path> files;
  if (!folder_.empty()) {
    files = files_in(folder_, ".3ds");
    const std::vector<fs::path> more = files_in(folder_ / "scenes", ".3ds");
    files.insert(files.end(), more.begin(), more.end());
  }
  std::string trouble;
  models_.scenes = read_all(files, trouble);
  if (!models_.scenes.empty() && trouble.empty()) {
    return;
  }
  // One generated scene is enough beside scenes of the user.
  const std::size_t wanted = models_.scenes.empty() ? kScenes.size() : 1;
  for (std::size_t i = 0; i < wanted; ++i) {
    models_.scenes.push_back(generated_scene(kScenes[i]));
    models_.scenes.back().trouble = trouble;
  }
}

void Finder::find_cities() {
  if (folder_.empty()) {
    return;
  }
  std::error_code error;
  const bool apart = fs::is_directory(folder_ / "cities", error);
  std::string trouble;
  models_.cities = read_all(files_in(apart ? folder_ / "cities" : folder_, ".ply"), trouble);
  if (!trouble.empty()) {
    models_.remarks.push_back("cities that were not used: " + trouble);
  }
  std::stable_sort(models_.cities.begin(), models_.cities.end(),
                   [](const Model& a, const Model& b) {
                     return a.mesh->triangles.size() < b.mesh->triangles.size();
                   });
}

void Finder::step() {
  check_stop(parallel_);
  ++done_;
  if (parallel_.progress) {
    parallel_.progress(static_cast<double>(done_) / static_cast<double>(done_ + 1));
  }
}

Models Finder::find(Needs needs) {
  std::error_code error;
  if (!folder_.empty() && !fs::is_directory(folder_, error)) {
    throw Error(ErrorKind::cannot_open, folder_.string() + ": no folder of models",
                "name the folder that the models are in");
  }
  check_stop(parallel_);
  for (const KnownObject& known : kObjects) {
    names_.emplace(known.name);
  }
  for (const KnownScene& known : kScenes) {
    names_.emplace(known.name);
  }
  if (needs.objects) {
    find_objects();
  }
  if (needs.scenes) {
    find_scenes();
  }
  if (needs.cities) {
    find_cities();
  }
  if (parallel_.progress) {
    parallel_.progress(1);
  }
  return std::move(models_);
}

}  // namespace

Models find_models(const fs::path& folder, Needs needs, const Parallel& parallel) {
  return Finder(folder, parallel).find(needs);
}

}  // namespace soms::reproduce
