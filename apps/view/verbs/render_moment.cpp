#include "apps/view/verbs/render_moment.h"

#include "soms/base/error.h"

#include "apps/cli/text.h"
#include "apps/view/drawing/length.h"
#include "apps/view/scene/contact_look.h"
#include "apps/view/verbs/render_rays.h"
#include "apps/view/verbs/render_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace soms::view {

namespace {

constexpr double kLeastSeen = 4;           ///< pixels
constexpr std::size_t kMostPlaces = 2000;  ///< of an entry that are looked at

/// True if a mover whose middle is one of these places is seen.
bool sees_any(const std::vector<Vec3>& places, const Camera& camera, Size size,
              const ViewScene& scene) {
  std::vector<Ray> rays;
  const std::size_t step = places.size() / kMostPlaces + 1;
  for (std::size_t k = 0; k < places.size(); k += step) {
    const auto seen = project(camera, size, places[k]);
    if (seen && seen->pixel.x >= 0 && seen->pixel.y >= 0 && seen->pixel.x < size.width &&
        seen->pixel.y < size.height) {
      rays.push_back(ray_through(camera, size, seen->pixel));
    }
  }
  const std::vector<SurfaceHit> hits = scene.first_hits(rays);
  return std::any_of(hits.begin(), hits.end(), [&](const SurfaceHit& hit) {
    if (!hit.body || hit.body->role != Role::mover) {
      return false;
    }
    const Box box = scene.bounds(*hit.body);
    const bool is_of_entry = std::any_of(places.begin(), places.end(),
                                         [&](const Vec3& place) { return place == box.center(); });
    return is_of_entry &&
           diagonal(box) >
               kLeastSeen * length_of_pixel(camera, size, length(hit.point - camera.eye));
  });
}

}  // namespace

void refuse_without_contact(Moment& moment, const Limits& limits) {
  if (moment.found) {
    throw Error(ErrorKind::usage,
                fmt::format("--camera contact: nothing touches in any of {}",
                            command::counted(moment.frames, "frame")),
                "leave out contact");
  }
  const std::uint64_t frame = moment.scene.frame();
  const auto nearest = nearest_touching_frame(moment.scene, moment.frames, limits);
  throw Error(
      ErrorKind::usage,
      moment.frames == 1 ? std::string("--camera contact: nothing touches")
                         : fmt::format("--camera contact: nothing touches in frame {}", frame),
      nearest ? fmt::format("give --frame {}, the nearest in which something does", *nearest)
              : std::string("leave out contact"));
}

CameraChoice::Subject chosen_subject(const RenderOptions& options, const ViewScene& scene) {
  CameraChoice choice = options.camera;
  choice.with_gap = draws_gap(options, scene);
  // Rays show no contacts, and a picture of boxes or of many poses is of all of them.
  choice.boxes = options.level || options.trace || is_ray_picture(options) ||
                 (!options.pose.empty() && scene.movers() > 1);
  return subject_of(choice, scene);
}

void keep_seen_entries(std::vector<KeyEntry>& key, const Camera& camera, Size size,
                       const ViewScene& scene) {
  key.erase(std::remove_if(key.begin(), key.end(),
                           [&](const KeyEntry& entry) {
                             return !entry.places.empty() &&
                                    !sees_any(entry.places, camera, size, scene);
                           }),
            key.end());
}

std::string words_of_moment(const Moment& moment, const AimedCamera& aimed) {
  std::string words;
  if (moment.found) {
    const RichFrame& found = *moment.found;
    words =
        found.touching_movers == 0
            ? fmt::format("nothing touches in {} of {}", command::with_commas(found.searched),
                          command::counted(found.frames, "frame"))
            : fmt::format("frame {} of {}, {} {}", found.frame, command::with_commas(found.frames),
                          command::counted(found.touching_movers, "mover"),
                          found.touching_movers == 1 ? "touches" : "touch");
  }
  if (aimed.pair) {
    const PartPair& pair = *aimed.pair;
    words += fmt::format("{}the camera looks at {} and {}", words.empty() ? "" : "; ",
                         name_of_part(moment.scene, pair.a, pair.part_a),
                         name_of_part(moment.scene, pair.b, pair.part_b));
  }
  return words;
}

}  // namespace soms::view
