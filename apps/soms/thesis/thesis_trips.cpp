#include "apps/soms/thesis/thesis_trips.h"

#include "soms/geometry/mesh.h"
#include "soms/thesis/thesis_frames.h"
#include "soms/tree/rule/rules.h"

#include "apps/cli/console.h"
#include "apps/model/models.h"
#include "apps/model/stated_options.h"
#include "apps/model/up_guess.h"
#include "apps/soms/thesis/thesis.h"
#include "apps/world/world.h"
#include "thesis/trips/levels.h"
#include "thesis/trips/models.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

namespace soms::command {

namespace {

/// A test's side, or nothing for the drive.
struct WantedTest {
  std::string_view name;
  std::optional<Approach> from;
};

std::vector<WantedTest> wanted_sides(const ThesisOptions& options) {
  std::vector<WantedTest> wanted;
  for (const auto& [from, name] : kAllApproaches) {
    const bool of_thesis = wanted.size() < kApproaches.size();
    if (options.test == name || options.test == kAllTests || (options.test.empty() && of_thesis)) {
      wanted.push_back({name, from});
    }
  }
  return wanted;
}

/// The trees of scenes have fewer levels. \source thesis, tables 5.3 and 5.9 by their captions.
BuildOptions build_of_scene(const ThesisOptions& options) {
  BuildOptions build = options.build;
  if (!options.levels_are_given) {
    build.level = reproduce::kSceneLevel;
  }
  return build;
}

LevelsOfTree levels_of(const BuildOptions& build) {
  return {build.level, build.root_level};
}

Shape thesis_shape(Mesh mesh, const BuildOptions& build, const Console& console) {
  return build_shape(std::move(mesh), {.build = build, .keep_tree = true}, console);
}

/// A model of a file, z up.
struct Upright {
  Mesh mesh;
  ThesisFile file;
  NamedFrame frame;  ///< its axis is settled, and so is its place: a test moves models together
};

/// Reads a model and turns it until z is up, which a note says unless an option did.
Upright read_upright(const std::string& path, const ModelOptions& options,
                     const std::string& scale_option, const std::string& up_option,
                     const Console& console) {
  Upright model{read_model(path, options, console),
                {.path = path,
                 .scale = options.scale,
                 .scale_is_given = options.scale_is_given,
                 .up = options.up},
                {}};
  model.frame = named_frame(model.mesh, options, scale_option, up_option);
  model.frame.frame.up = UpAxis::z;
  model.frame.frame.georeference = {};
  if (options.up != UpAxis::unknown) {
    return model;
  }
  const UpAxis stated = model.mesh.up;
  const std::string source = model.mesh.source;
  if (stated == UpAxis::x || stated == UpAxis::y) {
    model.file.up = stated;
    console.note(fmt::format("{}: the up axis is {}; rotated to z (give {} z to keep it)", source,
                             axis_letter(stated), up_option));
  } else if (stated == UpAxis::unknown && looks_y_up(model.mesh)) {
    model.file.up = UpAxis::y;
    console.note(
        fmt::format("{}: looks y up, and is rotated to z: the file names no axis ({} z keeps it)",
                    source, up_option));
  }
  model.mesh = transformed(std::move(model.mesh), 1, model.file.up);
  return model;
}

/// The trips of two models at hand.
std::vector<ThesisTrip> laid_out(ThesisTrip trip, const ThesisOptions& options) {
  const Box& still = trip.trip.a.bounds();
  const Box& moving = trip.trip.b.bounds();
  std::vector<ThesisTrip> trips;
  for (const WantedTest& test : wanted_sides(options)) {
    trip.trip.test = test.name;
    trip.trip.offsets = orientation_test(still, moving, *test.from, trip.up);
    trips.push_back(trip);
  }
  if (options.test == kDriveTest) {
    trip.trip.test = kDriveTest;
    trip.trip.offsets = drive_through(still, moving, trip.up);
    trips.push_back(std::move(trip));
  }
  return trips;
}

/// The trips of two files, or of one against itself.
ThesisTrips trips_of_files(const ThesisOptions& options, const Console& console) {
  const bool twice = options.b.empty();
  const bool drives = options.test == kDriveTest;
  const BuildOptions of_still = drives ? build_of_scene(options) : options.build;
  Upright still = read_upright(options.a, options.model_a, "--scale", "--up", console);
  Upright moving =
      twice ? still : read_upright(options.b, options.model_b, "--scale-b", "--up-b", console);
  std::vector<FrameWarning> warnings = frame_warnings(still.frame, moving.frame);
  tell_warnings(warnings, options.model_a.strict, console);
  ThesisTrip trip{.still_file = still.file,
                  .moving_file = moving.file,
                  .still_title = still.mesh.source,
                  .moving_title = moving.mesh.source,
                  .still_levels = levels_of(of_still),
                  .moving_levels = levels_of(options.build)};
  trip.trip.a = thesis_shape(std::move(still.mesh), of_still, console);
  trip.trip.b =
      twice && !drives ? trip.trip.a : thesis_shape(std::move(moving.mesh), options.build, console);
  trip.trip.still = short_name(options.a);
  trip.trip.moving = twice ? trip.trip.still : short_name(options.b);
  trip.trip.model = trip.trip.moving;
  trip.trip.rule = entry(options.build.rule).name;
  return {.trips = laid_out(std::move(trip), options), .warnings = std::move(warnings)};
}

/// The tests of one object of the thesis against its like, in the axes of its file: y is up, and
/// the counts are those of the golden tables.
void add_sides(std::vector<ThesisTrip>& trips, const reproduce::Model& object,
               const std::vector<WantedTest>& sides, const ThesisOptions& options,
               const Console& console) {
  const Shape shape = thesis_shape(*object.mesh, options.build, console);
  for (const WantedTest& test : sides) {
    trips.push_back({.trip = {.model = object.name,
                              .still = object.name,
                              .moving = object.name,
                              .test = std::string(test.name),
                              .rule = std::string(entry(options.build.rule).name),
                              .a = shape,
                              .b = shape,
                              .offsets = orientation_test(shape.bounds(), *test.from)},
                     .still_title = object.title,
                     .moving_title = object.title,
                     .up = 1,
                     .stand_in = object.stand_in,
                     .still_levels = levels_of(options.build),
                     .moving_levels = levels_of(options.build)});
  }
}

ThesisTrip drive_of_thesis(const reproduce::Model& scene, const reproduce::Model& object,
                           const ThesisOptions& options, const Console& console) {
  const BuildOptions of_scene = build_of_scene(options);
  return {
      .trip = {.model = object.name,
               .still = scene.name,
               .moving = fmt::format("{}{}", object.name, static_cast<int>(reproduce::kDriveScale)),
               .test = std::string(kDriveTest),
               .rule = std::string(entry(options.build.rule).name),
               .a = thesis_shape(*scene.mesh, of_scene, console),
               .b = thesis_shape(reproduce::driven(object), options.build, console),
               .offsets = city_drive()},
      .still_title = scene.title,
      .moving_title =
          fmt::format("{}, turned and {:g} times as large", object.title, reproduce::kDriveScale),
      .stand_in = scene.stand_in || object.stand_in,
      .still_levels = levels_of(of_scene),
      .moving_levels = levels_of(options.build)};
}

/// The thesis' experiment: its objects against their likes, and the drive of the first of them
/// through its urban scene.
ThesisTrips trips_of_thesis(const ThesisOptions& options, const Console& console) {
  const bool drives =
      options.test.empty() || options.test == kAllTests || options.test == kDriveTest;
  const reproduce::Models models = console.run("finding the models", [&](const Limits& limits) {
    return reproduce::find_models(options.models, {.objects = true, .scenes = drives}, limits);
  });
  ThesisTrips all{.remarks = models.remarks};
  for (const reproduce::Model& object : models.objects) {
    if (!options.models.empty() && !object.trouble.empty()) {
      all.remarks.push_back(object.trouble);
    }
  }
  const std::vector<WantedTest> sides = wanted_sides(options);
  for (const reproduce::Model& object : models.objects) {
    if (!sides.empty()) {
      add_sides(all.trips, object, sides, options, console);
    }
  }
  if (drives) {
    all.trips.push_back(
        drive_of_thesis(models.scenes.front(), models.objects.front(), options, console));
  }
  return all;
}

}  // namespace

ThesisTrips thesis_trips(const ThesisOptions& options, const Console& console) {
  return options.a.empty() ? trips_of_thesis(options, console) : trips_of_files(options, console);
}

}  // namespace soms::command
