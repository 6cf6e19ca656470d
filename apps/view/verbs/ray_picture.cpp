#include "apps/view/verbs/ray_picture.h"

#include "apps/cli/length_unit.h"
#include "apps/draw/picture_marks.h"
#include "apps/draw/stroke_font.h"
#include "apps/view/drawing/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>

namespace soms::view {

namespace {

constexpr std::size_t kRaysAtOnce = std::size_t{1} << 17;
constexpr Color kSky{247, 248, 250, 255};
constexpr Color kInSight = palette::kOrange;
constexpr Color kHidden{158, 164, 172, 255};
constexpr double kSightAmbient = 0.5;
constexpr double kDepthAmbient = 0.6;  // shapes show, and colors are still those of the key
constexpr double kRounded = 0x1p-30;   ///< of the way to a hit: where its own surface is met again

/// Place of sample `k` of `count` in a pixel: evenly spread both ways.
/// \source Hammersley 1960, by the radical inverse of base 2.
PixelPoint sample_place(int k, int count) {
  if (count == 1) {
    return {0.5, 0.5};
  }
  double inverse = 0;
  double digit = 0.5;
  for (int left = k; left > 0; left /= 2) {
    inverse += left % 2 * digit;
    digit /= 2;
  }
  return {(k + 0.5) / count, inverse + 0.5 / static_cast<double>(std::bit_ceil(unsigned(count)))};
}

/// Calls `use(first_row, rays, hits)` for the pixels of a picture in order, some rows at a time:
/// `samples` rays a pixel, and what each hits.
void for_pixels(
    const ViewScene& scene, const Camera& camera, Size size, int samples, const Limits& limits,
    const std::function<void(int, std::span<const Ray>, std::span<const SurfaceHit>)>& use) {
  const auto width = static_cast<std::size_t>(size.width);
  const auto height = static_cast<std::size_t>(size.height);
  const std::size_t a_row = width * static_cast<std::size_t>(samples);
  const std::size_t rows = std::max<std::size_t>(1, kRaysAtOnce / a_row);
  const Limits inner = limits.silent();
  std::vector<Ray> rays;
  for (std::size_t y = 0; y < height; y += rows) {
    check_stop(limits);
    rays.clear();
    for (std::size_t row = y; row < std::min(y + rows, height); ++row) {
      for (std::size_t x = 0; x < width; ++x) {
        for (int k = 0; k < samples; ++k) {
          const PixelPoint place = sample_place(k, samples);
          rays.push_back(
              ray_through(camera, size,
                          {static_cast<double>(x) + place.x, static_cast<double>(row) + place.y}));
        }
      }
    }
    use(static_cast<int>(y), rays, scene.first_hits(rays, true, inner));
    if (limits.progress) {
      limits.progress(static_cast<double>(std::min(y + rows, height)) /
                      static_cast<double>(height));
    }
  }
}

/// Writes the mean color of each pixel's samples, from the left end of a row.
void put_pixels(Picture& picture, int row, std::span<const Color> colors, int samples) {
  const auto each = static_cast<std::size_t>(samples);
  for (int p = 0; !colors.empty(); ++p, colors = colors.subspan(each)) {
    picture.put(p % picture.size.width, row + p / picture.size.width,
                look::mean_of(colors.first(each)));
  }
}

/// Distances by their ratios: 0 is the nearest, 1 the farthest.
class Scale {
 public:
  Scale(double nearest, double farthest) : low_(std::log(nearest)), high_(std::log(farthest)) {}

  [[nodiscard]] double at(double distance) const {
    return high_ > low_ ? std::clamp((std::log(distance) - low_) / (high_ - low_), 0.0, 1.0) : 0;
  }

 private:
  double low_;
  double high_;
};

/// 1, 2 and 5 times the powers of ten within a range.
std::vector<double> round_distances(double nearest, double farthest) {
  std::vector<double> found;
  for (int power = static_cast<int>(std::floor(std::log10(nearest)));
       power <= static_cast<int>(std::ceil(std::log10(farthest))); ++power) {
    for (const double digit : {1, 2, 5}) {
      const double d = digit * std::pow(10, power);
      if (nearest <= d && d <= farthest) {
        found.push_back(d);
      }
    }
  }
  return found;
}

/// " m", or nothing where the unit is not known or has no short name.
std::string unit_after_number(double meters) {
  const std::string name = command::unit_name(meters);
  return name.size() <= 2 ? " " + name : std::string();
}

/// The key: the colors below a title with the unit, and round distances below where there is room.
void draw_key(Picture& picture, const Scale& scale, double nearest, double farthest,
              double meters) {
  const std::string unit_text = unit_after_number(meters);
  const double unit = std::max(7.0, picture.size.height / 60.0);  // height of digits
  const double width = std::min(24 * unit, picture.size.width - 4 * unit);
  if (width < 8 * unit || picture.size.height < 8 * unit) {
    return;  // a picture as small as its key
  }
  const PixelPoint corner{picture.size.width - width - 2 * unit, picture.size.height - 5 * unit};
  draw_rectangle(picture, {corner.x - unit, corner.y - 2.6 * unit},
                 {corner.x + width + unit, corner.y + 4 * unit}, with_alpha(palette::kPaper, 225));
  draw_number(picture, {corner.x, corner.y - 0.8 * unit},
              meters > 0 ? "distance in " + command::unit_name(meters) : "distance, unit unknown",
              unit, palette::kGap);
  for (double x = 0; x < width; x += 1) {
    const double end = std::min(x + 2, width);  // the next one covers the soft edge
    draw_rectangle(picture, {corner.x + x, corner.y}, {corner.x + end, corner.y + 1.2 * unit},
                   ordered_color(x / width));
  }
  double free_from = corner.x - unit;
  for (const double d : round_distances(nearest, farthest)) {
    const std::string text = fmt::format("{:g}{}", d, unit_text);
    const double x = corner.x + scale.at(d) * width;
    const double left = x - look::width_of(text, unit) / 2;
    if (left < free_from || left + look::width_of(text, unit) > corner.x + width + 0.9 * unit) {
      continue;
    }
    draw_line(picture, {x, corner.y + 1.2 * unit}, {x, corner.y + 1.7 * unit}, unit / 8,
              palette::kGap);
    draw_number(picture, {left, corner.y + 3.2 * unit}, text, unit, palette::kGap);
    free_from = left + look::width_of(text, unit) + unit;
  }
}

Vec3 normal_of(const Triangle& t) {
  return cross(t.b - t.a, t.c - t.a);
}

/// A disc where the observer is in the picture, or a ring if it is hidden.
void mark_observer(Picture& picture, const ViewScene& scene, const Camera& camera,
                   const Vec3& observer) {
  const std::optional<Projection> at = project(camera, picture.size, observer);
  if (!at) {
    return;
  }
  const Ray ray{camera.eye, observer - camera.eye, 1 - kRounded};
  const bool hidden = scene.first_hits({&ray, 1}).front().body.has_value();
  const double radius = std::max(4.0, picture.size.height / 90.0);
  draw_mark(picture, at->pixel, radius, palette::kBlue, palette::kPaper);
  if (hidden) {
    draw_disc(picture, at->pixel, 0.55 * radius, palette::kPaper);
  }
}

}  // namespace

std::vector<std::uint8_t> seen_from(const ViewScene& scene, const Vec3& observer,
                                    std::span<const SurfaceHit> hits, std::span<const Ray> rays,
                                    const Limits& limits) {
  std::vector<std::uint8_t> seen(hits.size(), 0);
  std::vector<std::size_t> number;
  std::vector<Ray> ways;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    if (!hits[k].body) {
      continue;
    }
    const Vec3 way = hits[k].point - observer;
    const Vec3 normal = normal_of(scene.triangle(*hits[k].body, hits[k].triangle));
    if (way == Vec3{}) {
      seen[k] = 1;
    } else if (dot(normal, way) * dot(normal, rays[k].direction) > 0) {
      number.push_back(k);
      ways.push_back({observer, way, 1});
    }
  }
  const std::vector<SurfaceHit> first = scene.first_hits(ways, true, limits);
  for (std::size_t i = 0; i < first.size(); ++i) {
    const SurfaceHit& hit = hits[number[i]];
    const bool same = first[i].body == hit.body && first[i].triangle == hit.triangle;
    seen[number[i]] = same || first[i].t >= 1 - kRounded ? 1 : 0;
  }
  return seen;
}

std::string in_percent(std::uint64_t part, std::uint64_t whole) {
  const double share = whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
  return fmt::format("{:.1f} %", 100 * share);
}

DepthPicture draw_depth(const ViewScene& scene, const Camera& camera, Size size, int samples,
                        const Limits& limits, std::optional<double> meters) {
  DepthPicture drawn;
  drawn.nearest = std::numeric_limits<double>::infinity();
  for_pixels(scene, camera, size, 1, limits.silent(), [&](int, auto, auto hits) {
    for (const SurfaceHit& hit : hits) {
      if (hit.body) {
        drawn.nearest = std::min(drawn.nearest, hit.t);
        drawn.farthest = std::max(drawn.farthest, hit.t);
        ++drawn.surface;
      }
    }
  });
  drawn.picture = filled(size, kSky);
  if (drawn.surface == 0) {
    drawn.nearest = 0;
    return drawn;
  }
  // An eye on a surface has no ratios to it.
  const double nearest = std::max(drawn.nearest, 1e-9 * drawn.farthest);
  const Scale scale(nearest, drawn.farthest);
  const CameraFrame f = frame(camera);
  std::vector<Color> colors;
  for_pixels(scene, camera, size, samples, limits, [&](int row, auto rays, auto hits) {
    colors.clear();
    for (std::size_t k = 0; k < hits.size(); ++k) {
      if (!hits[k].body) {
        colors.push_back(kSky);
        continue;
      }
      const Triangle t = scene.triangle(*hits[k].body, hits[k].triangle);
      colors.push_back(
          look::lit(ordered_color(scale.at(hits[k].t)),
                    look::brightness(f, normal_of(t), rays[k].direction, kDepthAmbient)));
    }
    put_pixels(drawn.picture, row, colors, samples);
  });
  draw_key(drawn.picture, scale, nearest, drawn.farthest, meters.value_or(scene.unit()));
  return drawn;
}

std::vector<double> depths_of(const ViewScene& scene, const Camera& camera, Size size,
                              const Limits& limits) {
  std::vector<double> depths;
  for_pixels(scene, camera, size, 1, limits, [&](int, auto, auto hits) {
    for (const SurfaceHit& hit : hits) {
      depths.push_back(hit.body ? hit.t : std::numeric_limits<double>::quiet_NaN());
    }
  });
  return depths;
}

std::vector<std::uint8_t> sight_cells(const ViewScene& scene, const Camera& camera,
                                      const Vec3& observer, Size size, const Limits& limits) {
  std::vector<std::uint8_t> cells;
  for_pixels(scene, camera, size, 1, limits, [&](int, auto rays, auto hits) {
    const auto seen = seen_from(scene, observer, hits, rays, limits.silent());
    for (std::size_t k = 0; k < hits.size(); ++k) {
      cells.push_back(!hits[k].body ? kEmptyCell : seen[k] != 0 ? kSeenCell : kHiddenCell);
    }
  });
  return cells;
}

SightPicture draw_sight(const ViewScene& scene, const Camera& camera, const Vec3& observer,
                        Size size, int samples, const Limits& limits) {
  SightPicture drawn;
  drawn.picture = filled(size, kSky);
  const CameraFrame f = frame(camera);
  const Limits inner = limits.silent();
  std::vector<Color> colors;
  for_pixels(scene, camera, size, samples, limits,
             [&](int row, std::span<const Ray> rays, std::span<const SurfaceHit> hits) {
               const auto seen = seen_from(scene, observer, hits, rays, inner);
               colors.clear();
               for (std::size_t k = 0; k < hits.size(); ++k) {
                 if (!hits[k].body) {
                   colors.push_back(kSky);
                   continue;
                 }
                 const Triangle t = scene.triangle(*hits[k].body, hits[k].triangle);
                 colors.push_back(look::lit(
                     seen[k] != 0 ? kInSight : kHidden,
                     look::brightness(f, normal_of(t), rays[k].direction, kSightAmbient)));
                 ++drawn.surface;
                 drawn.in_sight += seen[k];
               }
               put_pixels(drawn.picture, row, colors, samples);
             });
  mark_observer(drawn.picture, scene, camera, observer);
  return drawn;
}

}  // namespace soms::view
