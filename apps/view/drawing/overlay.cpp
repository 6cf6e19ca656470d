#include "apps/view/drawing/overlay.h"

#include "apps/draw/stroke_font.h"
#include "apps/view/drawing/labels.h"
#include "apps/view/drawing/markers.h"
#include "apps/view/drawing/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace soms::view {

namespace {

constexpr double kOverlayPen = 0.15;  // of the height of digits
constexpr double kOverlayLetterRim = 2;
constexpr double kOverlayMargin = 18;
constexpr double kKeyHeight = 11;  // of letters, and of other lengths below in points
constexpr double kKeyRow = 24;
constexpr double kSignWidth = 26;
constexpr double kOverlayTitleHeight = 17;
constexpr double kOverlayDisc = 19;
constexpr double kOverlayDiscRim = 2.5;
constexpr double kOverlayArrow = 30;
constexpr double kOverlayLeastSide = 200;  // of pictures that have room for words

/// One picture's strokes.
class OverlayWriter {
 public:
  OverlayWriter(const DrawList& list, const Camera& camera, Size size)
      : list_(list), camera_(camera), size_(size) {}

  Overlay write() {
    labels();
    markers();
    if (std::min(size_.width, size_.height) >= kOverlayLeastSide * 0.7) {
      key();
      title();
      scale_and_north();
    }
    return std::move(overlay_);
  }

 private:
  void line(PixelPoint from, PixelPoint to, Color color, double width) {
    overlay_.strokes.push_back({from, to, color, width});
  }

  /// A line with a rim.
  void rimmed(PixelPoint from, PixelPoint to, Color color, double width, double rim) {
    line(from, to, palette::kPaper, width + 2 * rim);
    line(from, to, color, width);
  }

  /// Letters from the left end of their base line; with a rim of another color where `rim` is not
  /// the letters' own.
  void text(PixelPoint start, std::string_view words, double height, Color color, Color rim) {
    const std::vector<look::TextStroke> strokes = look::strokes_of(words, height);
    const double pen = kOverlayPen * height;
    for (const auto& [ink, width] :
         {std::pair(rim, pen + 2 * kOverlayLetterRim), std::pair(color, pen)}) {
      if (ink == color && width > pen) {
        continue;
      }
      for (const look::TextStroke& s : strokes) {
        line({start.x + s.from.x, start.y - s.from.y}, {start.x + s.to.x, start.y - s.to.y}, ink,
             width);
      }
    }
  }

  void labels() {
    const std::vector<PlacedLabel> placed = place_labels(list_.labels, camera_, size_);
    for (const PlacedLabel& place : placed) {
      const Label& label = list_.labels[place.label];
      // Whole pixels keep letters alike wherever they stand.
      text({std::round(place.upper_left.x), std::round(place.lower_right.y)}, label.text,
           label.height, label.color, label.rim);
    }
    overlay_.labels = placed.size();
  }

  void disc(PixelPoint at, std::string_view words, Color color) {
    const double height = 0.5 * kOverlayDisc;
    const double width = look::width_of(words, height);
    const double half = std::max(0.0, 0.5 * (width + 0.55 * kOverlayDisc - kOverlayDisc));
    rimmed({at.x - half, at.y}, {at.x + half, at.y}, color, kOverlayDisc, kOverlayDiscRim);
    text({at.x - 0.5 * width, at.y + 0.5 * height}, words, height, palette::kPaper,
         palette::kPaper);
  }

  void markers() {
    const std::vector<PlacedMarker> placed = place_markers(list_.markers, camera_, size_);
    for (const PlacedMarker& marker : placed) {
      disc(marker.at, std::to_string(marker.count), marker.color);
      overlay_.marked += marker.count;
    }
    overlay_.markers = placed.size();
  }

  [[nodiscard]] bool is_inside(const Vec3& place) const {
    const auto seen = project(camera_, size_, place);
    return seen && seen->pixel.x >= 0 && seen->pixel.y >= 0 && seen->pixel.x < size_.width &&
           seen->pixel.y < size_.height;
  }

  /// True if a contact's curve is inside the picture.
  [[nodiscard]] bool shows_curve() const {
    return std::any_of(list_.glows.begin(), list_.glows.end(),
                       [&](const Glow& glow) { return is_inside((glow.a + glow.b) * 0.5); });
  }

  [[nodiscard]] bool is_shown(const KeyEntry& entry) const {
    const bool there =
        entry.places.empty() || std::any_of(entry.places.begin(), entry.places.end(),
                                            [&](const Vec3& place) { return is_inside(place); });
    return (entry.sign == KeySign::area && there) ||
           (entry.sign == KeySign::marker && overlay_.markers > 0) ||
           (entry.sign == KeySign::curve && shows_curve());
  }

  void sign(const KeyEntry& entry, PixelPoint left) {
    const PixelPoint right{left.x + kSignWidth - 12, left.y};
    switch (entry.sign) {
      case KeySign::area:
        rimmed(left, right, entry.color, 10, 2);
        return;
      case KeySign::curve:
        rimmed(left, right, entry.color, 4, 2.5);
        return;
      case KeySign::marker:
        disc({0.5 * (left.x + right.x), left.y}, "n", entry.color);
        return;
    }
  }

  /// Where words begin that stand at the left.
  [[nodiscard]] double left_end() const {
    return kOverlayMargin + list_.captions.covered * size_.width;
  }

  /// Where they end above what covers the lower edge.
  [[nodiscard]] double lower_end() const {
    return size_.height * (1 - list_.captions.covered_below) - kOverlayMargin;
  }

  void key() {
    double y = lower_end();
    const std::vector<KeyEntry>& entries = list_.captions.key;
    for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
      if (is_shown(*entry)) {
        const double left = left_end();
        sign(*entry, {left, y - 0.5 * kKeyHeight});
        text({left + kSignWidth, y}, entry->text, kKeyHeight, palette::kInk, palette::kPaper);
        y -= kKeyRow;
      }
    }
  }

  void title() {
    if (!list_.captions.title.empty()) {
      text({left_end(), kOverlayMargin + kOverlayTitleHeight}, list_.captions.title,
           kOverlayTitleHeight, palette::kInk, palette::kPaper);
    }
  }

  void scale_and_north() {
    const Vec3 forward = frame(camera_).forward;
    if (forward.z > -0.17) {
      return;  // from the side, distances differ too much for one bar
    }
    const double right = size_.width * (1 - list_.captions.covered_right) - kOverlayMargin;
    double y = lower_end();
    if (list_.captions.meters > 0) {
      const ScaleBar bar = scale_bar(camera_, size_, list_.captions.meters);
      const bool kilometers = bar.meters >= 1000;
      const std::string words = kilometers ? fmt::format("{:g} km", bar.meters / 1000)
                                           : fmt::format("{:g} m", bar.meters);
      const double left = right - bar.pixels;
      for (const auto& [color, width] :
           {std::pair(palette::kPaper, 6.0), std::pair(palette::kInk, 2.0)}) {
        line({left, y}, {right, y}, color, width);
        line({left, y - 5}, {left, y}, color, width);
        line({right, y - 5}, {right, y}, color, width);
      }
      const double middle = 0.5 * (left + right - look::width_of(words, kKeyHeight));
      text({middle, y - 9}, words, kKeyHeight, palette::kInk, palette::kPaper);
      y -= 3 * kKeyRow / 2;
    }
    if (list_.captions.north) {
      north({right - kOverlayArrow, y - kOverlayArrow});
    }
  }

  /// An arrow about a place, as +y lies at the camera's target.
  void north(PixelPoint middle) {
    const double step = 1e-3 * distance_to_target(camera_);
    const auto from = project(camera_, size_, camera_.target);
    const auto to = project(camera_, size_, camera_.target + Vec3{0, step, 0});
    if (!from || !to) {
      return;
    }
    PixelPoint along{to->pixel.x - from->pixel.x, to->pixel.y - from->pixel.y};
    const double length = std::hypot(along.x, along.y);
    if (!(length > 0)) {
      return;
    }
    along = {along.x / length, along.y / length};
    const auto at = [&](double ahead, double aside) {
      return PixelPoint{middle.x + kOverlayArrow * (along.x * ahead - along.y * aside),
                        middle.y + kOverlayArrow * (along.y * ahead + along.x * aside)};
    };
    for (const auto& [color, width] :
         {std::pair(palette::kPaper, 6.0), std::pair(palette::kInk, 2.0)}) {
      line(at(-0.5, 0), at(0.5, 0), color, width);
      line(at(0.2, 0.18), at(0.5, 0), color, width);
      line(at(0.2, -0.18), at(0.5, 0), color, width);
    }
    const PixelPoint letter = at(0.85, 0);
    text({letter.x - 0.5 * look::width_of("N", kKeyHeight), letter.y + 0.5 * kKeyHeight}, "N",
         kKeyHeight, palette::kInk, palette::kPaper);
  }

  const DrawList& list_;
  const Camera& camera_;
  Size size_;
  Overlay overlay_;
};

}  // namespace

Overlay overlay_of(const DrawList& list, const Camera& camera, Size size) {
  return OverlayWriter(list, camera, size).write();
}

ScaleBar scale_bar(const Camera& camera, Size size, double meters) {
  const double pixel = length_of_pixel(camera, size, distance_to_target(camera)) * meters;
  const double most = 0.2 * size.width * pixel;
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  double length = decade;
  for (const double step : {2.0, 5.0}) {
    length = step * decade <= most ? step * decade : length;
  }
  return {length, length / pixel};
}

}  // namespace soms::view
