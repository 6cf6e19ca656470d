#include "thesis/races/touching_drive.h"

#include "soms/base/arithmetic.h"
#include "soms/base/parallel.h"
#include "soms/query/overlap.h"
#include "soms/thesis/thesis_frames.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr std::size_t kStripsAcross = 8;
constexpr std::size_t kHeights = 8;

/// A candidate line: where it runs, as parts of the scene's box.
struct DriveLine {
  std::size_t axis;  ///< 0: along x, 1: along y
  std::size_t
      across;  ///< one of `kStripsAcross` strips of equal width; the object is centered on it
  std::size_t height;  ///< the object's underside is at so many `kHeights`-ths of the height
};

std::vector<DriveLine> drive_lines() {
  std::vector<DriveLine> lines;
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    for (std::size_t height = 0; height < kHeights; ++height) {
      for (std::size_t across = 0; across < kStripsAcross; ++across) {
        lines.push_back({axis, across, height});
      }
    }
  }
  return lines;
}

std::vector<Vec3> offsets_along(const DriveLine& line, const Box& scene, const Box& mover) {
  const PlainArithmetic plain;
  const std::size_t side = 1 - line.axis;
  Vec3 offset{};
  offset[side] = scene.lower[side] +
                 scene.extent()[side] * (2 * static_cast<double>(line.across) + 1) /
                     (2 * static_cast<double>(kStripsAcross)) -
                 0.5 * (mover.lower[side] + mover.upper[side]);
  offset.z = scene.lower.z +
             scene.extent().z * static_cast<double>(line.height) / static_cast<double>(kHeights) -
             mover.lower.z;
  const double from = scene.lower[line.axis] - mover.upper[line.axis];
  const double to = scene.upper[line.axis] - mover.lower[line.axis];
  std::vector<Vec3> offsets(city_drive().size(), offset);
  const auto last = static_cast<double>(offsets.size() - 1);
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    offsets[k][line.axis] = from + (to - from) * (static_cast<double>(k) / last);
  }
  return offsets;
}

std::size_t contact_frames(const Shape& scene, const Shape& mover, const std::vector<Vec3>& offsets,
                           const Limits& limits) {
  std::size_t count = 0;
  for (const Vec3& by : offsets) {
    const Pose pose = Pose::translation(by.x, by.y, by.z);
    count += overlap(Body(scene), Body(mover, pose), {.mode = OverlapMode::any}, limits).any;
  }
  return count;
}

/// Twice the distance of a number of contact frames from half of all.
std::size_t off_half(std::size_t contact_frames, std::size_t frames) {
  const std::size_t twice = 2 * contact_frames;
  return twice < frames ? frames - twice : twice - frames;
}

/// A drive as processes tell it to one another.
Decision numbers_of(const TouchingDrive& drive) {
  Decision numbers{static_cast<double>(drive.contact_frames), static_cast<double>(drive.lines),
                   static_cast<double>(drive.touching_lines)};
  for (const Vec3& by : drive.offsets) {
    numbers.insert(numbers.end(), {by.x, by.y, by.z});
  }
  return numbers;
}

TouchingDrive drive_of(const Decision& numbers) {
  TouchingDrive drive{.contact_frames = static_cast<std::size_t>(numbers.at(0)),
                      .lines = static_cast<std::size_t>(numbers.at(1)),
                      .touching_lines = static_cast<std::size_t>(numbers.at(2))};
  for (std::size_t i = 3; i + 2 < numbers.size(); i += 3) {
    drive.offsets.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  }
  return drive;
}

}  // namespace

TouchingDrive find_touching_drive(const Model& scene, const Model& object, const Limits& limits) {
  const Shape still(scene.mesh);
  const Shape mover(std::make_shared<const Mesh>(driven(object)));
  const Limits quiet = limits.alone();
  TouchingDrive best{.offsets = city_drive()};
  if (still.bounds().empty() || mover.bounds().empty()) {
    return best;
  }
  const std::vector<DriveLine> lines = drive_lines();
  std::vector<std::size_t> counts(lines.size());
  for_each_chunk(lines.size(), 1, {.threads = limits.threads, .stop = limits.stop},
                 [&](std::size_t i, std::size_t) {
                   const auto offsets = offsets_along(lines[i], still.bounds(), mover.bounds());
                   counts[i] = contact_frames(still, mover, offsets, quiet);
                 });
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<Vec3> offsets = offsets_along(lines[i], still.bounds(), mover.bounds());
    const std::size_t count = counts[i];
    best.touching_lines += count > 0 ? 1U : 0U;
    if (best.lines == 0 ||
        off_half(count, offsets.size()) < off_half(best.contact_frames, offsets.size())) {
      best.offsets = std::move(offsets);
      best.contact_frames = count;
    }
    ++best.lines;
  }
  return best;
}

Trip touching_drive_trip(const Model& scene, const Model& object, const Contender& build_of_scene,
                         const Contender& build_of_object, const TouchingDrive& drive) {
  Trip trip = drive_trip(scene, object, build_of_scene, build_of_object);
  trip.test = "touching_drive";
  trip.offsets = drive.offsets;
  return trip;
}

const TouchingDrive& TouchingDrives::of(const Model& scene, const Model& object,
                                        const Limits& limits) {
  const std::pair key(scene.name, object.name);
  const auto found = found_.find(key);
  return found != found_.end()
             ? found->second
             : found_.emplace(key, find_touching_drive(scene, object, limits)).first->second;
}

TouchingDrive touching_drive(const Context& context, const Model& scene, const Model& object) {
  const Limits counting = context.counting();
  const Decision decision = context.races->decide(
      fmt::format("touching drive of {} through {}", object.name, scene.name), [&] {
        return numbers_of(context.touching != nullptr
                              ? context.touching->of(scene, object, counting)
                              : find_touching_drive(scene, object, counting));
      });
  return drive_of(decision);
}

std::string touching_drive_remark(const Model& scene, const Model& object,
                                  const TouchingDrive& drive) {
  if (drive.contact_frames == 0) {
    return fmt::format(
        "touching_drive of {} through {}: on none of {} lines does the object touch the "
        "scene, so this drive has no contact frames.",
        object.name, scene.name, drive.lines);
  }
  const Vec3& from = drive.offsets.front();
  const bool along_x = from.y == drive.offsets.back().y;
  return fmt::format(
      "touching_drive of {} through {}: along {} at {} = {:.6g}, z = {:.6g} (offsets of "
      "the object), contact in {} of {} frames, the nearest to half of them on "
      "{} lines.",
      object.name, scene.name, along_x ? "x" : "y", along_x ? "y" : "x", along_x ? from.y : from.x,
      from.z, drive.contact_frames, drive.offsets.size(), drive.lines);
}

}  // namespace soms::reproduce
