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
  Scene (*make)(std::uint64_t triangles, std::uint64_t seed);
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

/// Two bodies of files that are nothing like each other, and how they are put to each other.
struct Unlike {
  const char* name;
  const char* mover;
  const char* fixed;
  double scale = 1;  ///< makes meters of the mover's coordinates; of both in a hall
  enum class In { city, space, hall } in = In::city;

  [[nodiscard]] Scene make(const std::filesystem::path& data, std::uint64_t seed) const {
    switch (in) {
      case In::space:
        return unlike_models_scene(name, data / mover, data / fixed, seed);
      case In::hall:
        return unlike_hall_scene(name, data / mover, data / fixed, scale, seed);
      case In::city:
        break;
    }
    return unlike_city_scene(name, data / fixed, data / mover, scale, seed);
  }
};

// A jeep is about 3.8 m long; the file's is 16.65 units.
constexpr std::array kUnlike{
    Unlike{"unlike-van-delft", "3ds/van_disim.3ds", "cities/delft.ply"},
    Unlike{"unlike-truck-lyon", "3ds/truck_disim.3ds", "cities/lyon.ply"},
    Unlike{"unlike-jeep-rotterdam", "3ds/jeep1.3ds", "cities/rotterdam.ply", 0.23},
    Unlike{"unlike-f16-helicopter", "ply/f16.ply", "ply/hind.ply", 1, Unlike::In::space},
    Unlike{"unlike-ship-cow", "ply/galleon.ply", "ply/cow.ply", 1, Unlike::In::space},
    Unlike{"unlike-chairs-hall", "3ds/chairs.3ds", "3ds/lecture_hall.3ds", 0.01, Unlike::In::hall},
};

}  // namespace

std::vector<Offer> catalog(const std::filesystem::path& data, std::uint64_t seed) {
  std::vector<Offer> offers;
  offers.reserve(kGenerated.size() + kModels.size() + kCities.size() + kClosedModels.size() +
                 kUnlike.size() + 3);
  for (const Generated& g : kGenerated) {
    offers.push_back(
        {g.name, g.triangles, g.quick, [g, seed] { return g.make(g.triangles, seed); }});
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
        [file, seed] { return model_scene(file, seed); });
  }
  for (const std::string_view model : kClosedModels) {
    const auto file = data / model;
    add("probe-" + file.stem().string(), file, false,
        [file, seed] { return model_probes(file, seed); });
  }
  for (const ListedCity& city : kCities) {
    const std::string name(city.name);
    const auto file = data / "cities" / (std::string(city.file) + ".ply");
    const auto mover = data / "3ds" / (std::string(city.mover) + ".3ds");
    add(name, file, &city == kCities.data(),
        [name, file, mover, seed] { return real_city_scene(name, file, mover, seed); });
  }
  for (const Unlike& pair : kUnlike) {
    if (std::filesystem::exists(data / pair.mover)) {
      add(pair.name, data / pair.fixed, false,
          [pair, data, seed] { return pair.make(data, seed); });
    }
  }
  offers.push_back({"unlike-arm-cell", 0, false, [seed] { return arm_scene(seed); }});
  for (const std::uint64_t boxes : {std::uint64_t{10'000}, std::uint64_t{100'000}}) {
    offers.push_back({"moving-boxes", boxes, boxes == 10'000,
                      [boxes, seed] { return moving_boxes_scene(boxes, seed); }});
  }
  return offers;
}

}  // namespace soms::bench
