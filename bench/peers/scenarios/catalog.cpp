#include "bench/peers/scenarios/catalog.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace soms::bench {

namespace {

struct Generated {
  const char* name;
  std::uint64_t triangles;
  bool quick;
  Scene (*make)(std::uint64_t);
};

constexpr std::array kGenerated{
    Generated{"twins-knot", 1'000, true, knot_scene},
    Generated{"twins-knot", 10'000, true, knot_scene},
    Generated{"twins-knot", 100'000, true, knot_scene},
    Generated{"twins-knot", 1'000'000, false, knot_scene},
    Generated{"city-car", 5'672, true, city_car_scene},
    Generated{"city-car", 100'000, false, city_car_scene},
    Generated{"city-car", 1'000'000, true, city_car_scene},
    Generated{"city-car", 5'000'000, false, city_car_scene},
    Generated{"city-drone", 5'672, true, city_drone_scene},
    Generated{"city-drone", 100'000, false, city_drone_scene},
    Generated{"city-drone", 1'000'000, true, city_drone_scene},
    Generated{"city-drone", 5'000'000, false, city_drone_scene},
    Generated{"far-knot", 1'000, true, far_scene},
    Generated{"far-knot", 100'000, false, far_scene},
    Generated{"streets", 5'672, false, street_scene},
    Generated{"streets", 1'000'000, false, street_scene},
    Generated{"probe-knot", 1'000, true, knot_probes},
    Generated{"probe-knot", 10'000, false, knot_probes},
    Generated{"probe-knot", 100'000, true, knot_probes},
    Generated{"probe-knot", 1'000'000, false, knot_probes},
    Generated{"probe-city", 5'672, true, city_probes},
    Generated{"probe-city", 100'000, false, city_probes},
    Generated{"probe-city", 1'000'000, true, city_probes},
};

constexpr std::array<std::string_view, 7> kModels{
    "bun_zipper", "igea", "cow", "galleon", "teapot", "beethoven", "big_porsche"};

/// Closed models, which have an inside.
constexpr std::array<std::string_view, 3> kClosedModels{"other/fertility.off",
                                                        "other/armadillo.obj", "ply/igea.ply"};

struct ListedCity {
  std::string_view name;
  std::string_view file;
  std::string_view mover;
};

constexpr std::array kCities{
    ListedCity{"real-rotterdam", "rotterdam", "car_disim"},
    ListedCity{"real-new_york_south", "new_york_south", "car_disim"},
    ListedCity{"real-new_york_mid", "new_york_mid", "car_disim"},
    ListedCity{"real-lyon", "lyon", "car_disim"},
    ListedCity{"real-delft", "delft", "car_disim"},
    ListedCity{"real-berlin_sample", "berlin_sample", "car_disim"},
    ListedCity{"real-delft-van", "delft", "van_disim"},
    ListedCity{"real-lyon-truck", "lyon", "truck_disim"},
};

}  // namespace

std::vector<Offer> catalog(const std::filesystem::path& data) {
  std::vector<Offer> offers;
  offers.reserve(kGenerated.size() + kModels.size() + kCities.size() + kClosedModels.size() + 2);
  for (const Generated& g : kGenerated) {
    offers.push_back({g.name, g.triangles, g.quick, [g] { return g.make(g.triangles); }});
  }
  const auto add = [&](const std::string& scene, const std::filesystem::path& file, bool quick,
                       std::function<Scene()> make) {
    if (!data.empty() && std::filesystem::exists(file)) {
      offers.push_back({scene, 0, quick, std::move(make)});
    }
  };
  for (const std::string_view model : kModels) {
    const auto file = data / "ply" / (std::string(model) + ".ply");
    add("twins-" + std::string(model), file, model == kModels[0],
        [file] { return model_scene(file); });
  }
  for (const std::string_view model : kClosedModels) {
    const auto file = data / model;
    add("probe-" + file.stem().string(), file, false, [file] { return model_probes(file); });
  }
  for (const ListedCity& city : kCities) {
    const std::string name(city.name);
    const auto file = data / "cities" / (std::string(city.file) + ".ply");
    const auto mover = data / "3ds" / (std::string(city.mover) + ".3ds");
    add(name, file, &city == kCities.data(),
        [name, file, mover] { return real_city_scene(name, file, mover); });
  }
  for (const std::uint64_t boxes : {std::uint64_t{10'000}, std::uint64_t{100'000}}) {
    offers.push_back(
        {"moving-boxes", boxes, boxes == 10'000, [boxes] { return moving_boxes_scene(boxes); }});
  }
  return offers;
}

}  // namespace soms::bench
