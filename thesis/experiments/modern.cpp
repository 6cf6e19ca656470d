#include "soms/generate/city.h"
#include "soms/generate/shapes.h"

#include "thesis/claims/comparison.h"
#include "thesis/experiments/experiments.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>

namespace soms::reproduce {

namespace {

/// Models of more triangles are built by fewer rules, and timed fewer times.
constexpr std::size_t kLargeScene = 400'000;

/// A model and what moves through it.
struct Case {
  const Model* model = nullptr;
  int level = 15;         ///< of the thesis for models of this kind
  bool is_scene = false;  ///< in meters, so that a car fits
};

/// For objects a drone a fifth as large; for scenes a car.
Workload workload_for(const Case& c, bool quick) {
  const Mesh& mesh = *c.model->mesh;
  const int cubes = quick ? 300 : 1000;
  const int poses = quick ? 100 : 500;
  if (c.is_scene) {
    return make_workload(mesh, generate_mover(MoverKind::car), "car", cubes, poses);
  }
  const Vec3 extent = bounds(mesh).extent();
  const double scale = 0.2 * std::max({extent.x, extent.y, extent.z}) / 0.75;
  return make_workload(mesh, transformed(generate_mover(MoverKind::drone), scale, UpAxis::z),
                       "drone, scaled", cubes, poses);
}

Result compare_all(const std::string& prefix, const std::vector<Case>& cases,
                   const Context& context) {
  std::vector<Compared> all;
  std::vector<std::string> large;
  std::size_t done = 0;
  const auto triangles = [](std::size_t sum, const Case& c) {
    return sum + c.model->mesh->triangles.size();
  };
  const std::size_t total = std::accumulate(cases.begin(), cases.end(), std::size_t{1}, triangles);
  for (const Case& c : cases) {
    check_stop(context.limits);
    const std::size_t size = c.model->mesh->triangles.size();
    if (size > kLargeScene) {
      large.push_back(c.model->title);
    }
    if (size > 0) {
      const int repetitions = size > kLargeScene / 4 ? 3 : context.quick ? 9 : 15;
      all.push_back(compare(*c.model, compared_builds(c.level, size > kLargeScene),
                            workload_for(c, context.quick), repetitions, context.limits));
    }
    done += size;
    if (context.limits.progress) {
      context.limits.progress(static_cast<double>(done) / static_cast<double>(total));
    }
  }
  Result result = report(prefix, all);
  if (!large.empty()) {
    result.remarks.push_back(
        fmt::format("Of more than {} triangles, so built by fewer rules and timed 3 times: {}.",
                    kLargeScene, fmt::join(large, "; ")));
  }
  return result;
}

Model generated_city(bool quick) {
  CityOptions options;
  options.triangles = quick ? 20'000 : 300'000;
  Model model{.name = "generated_city",
              .title = fmt::format("generated city of {} triangles", options.triangles),
              .stand_in = true};
  model.mesh = std::make_shared<const Mesh>(generate_city(options).mesh);
  model.hash = corner_hash(*model.mesh);
  return model;
}

}  // namespace

Result modern(const Context& context) {
  std::vector<Case> cases;
  for (const Model& model : context.models.objects) {
    cases.push_back({&model, 15, false});
  }
  for (const Model& model : context.models.scenes) {
    cases.push_back({&model, 13, true});
  }
  return compare_all("modern", cases, context);
}

Result cities(const Context& context) {
  std::vector<Case> cases;
  for (const Model& model : context.models.cities) {
    if (!context.quick || cases.size() < 2) {
      cases.push_back({&model, 13, true});
    }
  }
  if (!cases.empty()) {
    Result result = compare_all("cities", cases, context);
    if (cases.size() < context.models.cities.size()) {
      result.remarks.push_back(fmt::format("A quick run: the {} smallest of {} cities.",
                                           cases.size(), context.models.cities.size()));
    }
    return result;
  }
  const Model city = generated_city(context.quick);
  Result result = compare_all("cities", {{&city, 13, true}}, context);
  result.remarks.push_back(
      "No city was given, so this is a generated one. To compare on real ones, put them as PLY "
      "files, in meters and z up, into the folder `cities` of the folder given by `--models`.");
  return result;
}

}  // namespace soms::reproduce
