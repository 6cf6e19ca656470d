#include "apps/world/route_notes.h"

#include "soms/base/error.h"

#include "apps/cli/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::command {

namespace {

/// Says `note` on standard error and in the answer; with `strict` it is an error instead.
void note_route(World& world, const std::string& note, const std::string& remedy, bool strict,
                const Console& console) {
  if (strict) {
    throw Error(ErrorKind::bad_file, note, remedy);
  }
  console.note(note);
  world.notes.push_back(note);
}

}  // namespace

std::uint64_t longest_poses(const World& world) {
  std::uint64_t most = 0;
  for (const MoverRoute& route : world.routes) {
    if (route.recorded != nullptr) {
      most = std::max<std::uint64_t>(most, route.recorded->size());
    }
  }
  return most;
}

std::uint64_t frames_of_routes(const World& world, std::uint64_t usual) {
  const std::uint64_t rows = longest_poses(world);
  const bool all_poses =
      rows > 0 && std::all_of(world.routes.begin(), world.routes.end(),
                              [](const MoverRoute& route) { return route.recorded != nullptr; });
  return all_poses ? rows : std::max(rows, usual);
}

void note_uneven_routes(World& world, bool strict, const Console& console) {
  std::size_t least = 0;
  std::size_t most = 0;
  for (const MoverRoute& route : world.routes) {
    if (route.recorded != nullptr) {
      const std::size_t rows = route.recorded->size();
      least = least == 0 ? rows : std::min(least, rows);
      most = std::max(most, rows);
    }
  }
  if (least == most) {
    return;
  }
  const std::string note = fmt::format(
      "--route: the files of poses have {} to {} rows; the shorter ones start over "
      "while the others go on",
      least, most);
  note_route(world, note, "give files of equal length", strict, console);
}

void note_unused_rows(World& world, std::uint64_t frames, bool strict, const Console& console) {
  const std::uint64_t rows = longest_poses(world);
  if (rows > frames) {
    note_route(world,
               fmt::format("--frames {} ends before the poses do: the longest --route has {} rows",
                           frames, rows),
               fmt::format("give --frames {}, or leave it out", rows), strict, console);
  }
}

void note_long_steps(World& world, bool strict, const Console& console) {
  std::uint64_t count = 0;
  const Model* first = nullptr;
  for (const MoverRoute& route : world.routes) {
    const Model& model = world.models[route.model];
    // The model heads along its route with +x.
    if (route.recorded == nullptr && route.path.length() > 0 &&
        route.path.speed / kFramesASecond > model.shape.bounds().extent().x) {
      first = count == 0 ? &model : first;
      ++count;
    }
  }
  if (count > 0) {
    note_route(
        world,
        fmt::format("{} {} in steps of {:.3g} m, longer than the model ({}: {:.3g} m): {} can "
                    "pass thin walls between two frames",
                    count == 1 ? "1 mover" : with_commas(count) + " movers",
                    count == 1 ? "goes" : "go", first->speed / kFramesASecond, first->name,
                    first->shape.bounds().extent().x, count == 1 ? "it" : "they"),
        "give a route of poses in smaller steps, or --swept", strict, console);
  }
}

}  // namespace soms::command
