/// \file
/// A small writer of SVG documents: the one look of all charts and drawings, in light and dark.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// A point of the page in pixels, y downwards.
struct Spot {
  double x = 0;
  double y = 0;
};

/// Series colors that the color-blind tell apart, as #rrggbb; cycles. Classes sN (stroke) and fN
/// (fill), N below kSeriesColors, wear them and turn lighter where the reader's screen is dark; so
/// do the classes fa and fb, the fills of bodies A and B. Colors are from apps/draw/look.h.
inline constexpr std::size_t kSeriesColors = 8;
[[nodiscard]] std::string series_color(std::size_t series);

/// Which side of its spot a text stands on.
enum class Anchor { start, middle, end };

/// How a text looks.
struct TextLook {
  double size = 14;
  Anchor anchor = Anchor::start;
  bool bold = false;
  bool faint = false;     ///< secondary: axis numbers, notes
  bool haloed = false;    ///< with a rim of the paper's color, to be read above lines
  std::string more = {};  ///< further attributes
};

/// A document that grows. Nothing in it has an id, so that many may stand in one HTML page.
/// Attributes are given as SVG ("stroke-width=\"2\""); words are escaped.
class Svg {
 public:
  /// The paper, `width` by `height`; `title` is what it shows, for who cannot see it.
  Svg(double width, double height, std::string_view title);

  void path(std::string_view d, std::string_view attributes);
  void rect(Spot corner, double width, double height, std::string_view attributes);
  void circle(Spot center, double radius, std::string_view attributes);
  void line(Spot from, Spot to, std::string_view attributes);
  void text(Spot at, std::string_view words, const TextLook& look = {});
  /// One line below the other, `1.25 size` apart; `at` is the first's baseline.
  void lines(Spot at, const std::vector<std::string>& words, const TextLook& look = {});
  void open_group(std::string_view attributes);
  void close_group();

  /// Bytes so far.
  [[nodiscard]] std::size_t size() const { return body_.size(); }

  /// The whole document.
  [[nodiscard]] std::string document() const;

 private:
  double width_;
  double height_;
  std::string title_;
  std::string body_;
};

/// A coordinate with at most two decimals; never "-0", never an exponent.
[[nodiscard]] std::string pixels(double value);

/// "x,y" of a path.
[[nodiscard]] std::string pixels(Spot spot);

/// The `d` of a path through points.
class PathData {
 public:
  PathData& move(Spot to) { return add('M', to); }

  PathData& line(Spot to) { return add('L', to); }

  /// A line, or where the path begins a move.
  PathData& next(Spot to) { return add(data_.empty() ? 'M' : 'L', to); }

  PathData& close() {
    data_ += 'z';
    return *this;
  }

  [[nodiscard]] const std::string& data() const { return data_; }

 private:
  PathData& add(char command, Spot to);

  std::string data_;
};

/// About how wide `words` are, a little too wide rather than too narrow.
[[nodiscard]] double text_width(std::string_view words, double size, bool bold = false);

/// `words` broken at spaces into lines of at most `width` (a longer word keeps its own line).
[[nodiscard]] std::vector<std::string> wrapped(std::string_view words, double size, double width,
                                               bool bold = false);

}  // namespace soms::reproduce
