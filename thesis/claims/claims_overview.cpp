#include "thesis/claims/claims_overview.h"

#include "soms/base/text.h"

#include "apps/draw/svg.h"
#include "thesis/claims/claim.h"
#include "thesis/claims/nearest_verdict.h"
#include "thesis/page/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace soms::reproduce {

namespace {

/// How a line of a matrix stands: what its cell shows.
enum class LineStand { holds, holds_in_part, undecided, fails, not_judged };

struct CellLook {
  std::string_view css;   ///< class that has the color
  std::string_view sign;  ///< for those who cannot tell the colors apart
  std::string_view words;
};

constexpr std::array<CellLook, 5> kLooks{{
    {"holds", "&#10003;", "every judged row holds"},
    {"holds_on_some", "&#8764;", "some rows hold"},
    {"undecided", "&#177;", "none holds, and some are undecided"},
    {"does_not_hold", "&#10007;", "every judged row fails"},
    {"cannot_be_checked", "&#8211;", "no row is judged"},
}};

const CellLook& look_of(LineStand stand) {
  return kLooks[static_cast<std::size_t>(stand)];
}

/// The rows of one reading by one metric, counted.
struct LineCounts {
  std::size_t hold = 0;
  std::size_t undecided = 0;
  std::size_t fail = 0;

  [[nodiscard]] std::size_t judged() const { return hold + undecided + fail; }

  [[nodiscard]] LineStand stand() const {
    return judged() == 0      ? LineStand::not_judged
           : hold == judged() ? LineStand::holds
           : hold > 0         ? LineStand::holds_in_part
           : undecided > 0    ? LineStand::undecided
                              : LineStand::fails;
  }
};

LineCounts counts_of(const std::vector<const ClaimRow*>& line) {
  LineCounts counts;
  for (const ClaimRow* row : line) {
    const Verdict stand = stand_of(*row);
    counts.hold += stand == Verdict::holds ? 1U : 0U;
    counts.undecided += stand == Verdict::undecided ? 1U : 0U;
    counts.fail += stand == Verdict::does_not_hold ? 1U : 0U;
  }
  return counts;
}

/// "stop, inner axis: relative gain (> 8): 2 of 7 rows hold".
std::string line_words(const std::vector<const ClaimRow*>& line, const LineCounts& counts) {
  const ClaimRow& first = *line.front();
  const std::string name =
      first.reading.empty() ? first.metric : fmt::format("{}: {}", first.reading, first.metric);
  return counts.judged() == 0 ? fmt::format("{} ({}): not judged", name, words_of(first.demand))
                              : fmt::format("{} ({}): {} of {} rows hold", name,
                                            words_of(first.demand), counts.hold, counts.judged());
}

/// How the matrix is laid out, in pixels.
struct MatrixLook {
  double width = 0;
  double claim_width = 0;    ///< of the column of claims
  double nearest_width = 0;  ///< of the verdicts of the nearest reading
  double stand_width = 0;    ///< of those over all readings
  bool is_narrow = false;    ///< verdicts and cells stand below the claim
  std::string_view css;      ///< class that says on which screens it is shown
};

constexpr MatrixLook kWide{1056, 316, 148, 220, false, "wide"};
constexpr MatrixLook kNarrow{350, 350, 0, 0, true, "narrow"};
constexpr double kLetters = 12.5;  // size of letters
constexpr double kLineOfText = 16;
constexpr double kCellPitch = 14;
constexpr double kCellSize = 12;
constexpr double kRowGap = 8;

/// Draws one row after the other.
class MatrixDrawing {
 public:
  explicit MatrixDrawing(const MatrixLook& look) : look_(look) {}

  void heads() {
    if (look_.is_narrow) {
      return;
    }
    y_ += kLineOfText;
    head(0, "claim");
    head(look_.claim_width, "nearest to the text");
    head(look_.claim_width + look_.nearest_width, "over all readings");
    head(cells_left(), "its readings, a cell each");
    y_ += kRowGap;
  }

  void row(const Claim& claim, std::string_view item) {
    line();
    const double top = y_ + kRowGap / 2;
    y_ = top;
    const double words = link_words(claim);
    y_ = look_.is_narrow ? top + words : top;
    stands(claim);
    const double cells = this->cells(claim, item);
    y_ = look_.is_narrow ? y_ + cells : top + std::max(words, cells + 1);
    y_ += kRowGap / 2;
  }

  std::string svg() {
    line();
    return fmt::format(
        "<svg class=\"matrix {}\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" "
        "role=\"group\" aria-label=\"Claims by readings\">\n{}</svg>\n",
        look_.css, look_.width, y_ + 1, parts_);
  }

 private:
  [[nodiscard]] double cells_left() const {
    return look_.is_narrow ? 0 : look_.claim_width + look_.nearest_width + look_.stand_width;
  }

  void line() { parts_ += fmt::format("<path class=\"rule\" d=\"M0 {}H{}\"/>\n", y_, look_.width); }

  void head(double x, std::string_view words) {
    parts_ += fmt::format("<text class=\"head\" x=\"{}\" y=\"{}\">{}</text>\n", x, y_ - 3, words);
  }

  /// The height of the words.
  double link_words(const Claim& claim) {
    const std::vector<std::string> lines =
        wrapped(claim.statement, kLetters, look_.claim_width - 14, false);
    parts_ += fmt::format("<a href=\"#claim-{}\">", xml_text(claim.id));
    for (std::size_t k = 0; k < lines.size(); ++k) {
      parts_ += fmt::format("<text x=\"0\" y=\"{}\">{}</text>",
                            y_ + 12 + kLineOfText * static_cast<double>(k), xml_text(lines[k]));
    }
    parts_ += "</a>\n";
    return kLineOfText * static_cast<double>(lines.size());
  }

  /// The two verdicts: in columns, or one below the other with what they are of.
  void stands(const Claim& claim) {
    const NearestVerdict nearest = nearest_of(claim);
    const Verdict over_all = verdict_of(claim);
    const std::string near = fmt::format("{} {}", sign_of(nearest.stand), name(nearest.stand));
    const std::string all = fmt::format("{} {}", sign_of(over_all), name(over_all));
    if (look_.is_narrow) {
      stand(0, "nearest to the text: " + near, class_of(nearest.stand));
      y_ += kLineOfText;
      stand(0, "over all readings: " + all, class_of(over_all));
      y_ += kLineOfText + 2;
    } else {
      stand(look_.claim_width, near, class_of(nearest.stand));
      stand(look_.claim_width + look_.nearest_width, all, class_of(over_all));
      y_ += 1;
    }
  }

  void stand(double x, const std::string& words, std::string_view css) {
    parts_ += fmt::format("<text class=\"stand {}\" x=\"{}\" y=\"{}\">{}</text>\n", css, x, y_ + 12,
                          words);
  }

  /// The cells of a claim: those of the nearest reading first, the others as in the matrix. Their
  /// height.
  double cells(const Claim& claim, std::string_view item) {
    std::vector<std::vector<const ClaimRow*>> lines = lines_of(claim);
    std::stable_partition(
        lines.begin(), lines.end(),
        [&](const std::vector<const ClaimRow*>& line) { return is_nearest(claim, *line.front()); });
    const auto a_line = static_cast<std::size_t>((look_.width - cells_left()) / kCellPitch);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      cell(claim, lines[k], item, cells_left() + kCellPitch * static_cast<double>(k % a_line) + 1,
           y_ + kCellPitch * static_cast<double>(k / a_line) + 1);
    }
    return kCellPitch * static_cast<double>((lines.size() + a_line - 1) / a_line) + 2;
  }

  void cell(const Claim& claim, const std::vector<const ClaimRow*>& line, std::string_view item,
            double x, double y) {
    const LineCounts counts = counts_of(line);
    const CellLook& look = look_of(counts.stand());
    parts_ += fmt::format(
        "<a class=\"cell {}{}\" href=\"#item-{}\"><title>{}</title><rect x=\"{}\" y=\"{}\" "
        "width=\"{}\" height=\"{}\" rx=\"2\"/><text x=\"{}\" y=\"{}\">{}</text></a>\n",
        look.css, is_nearest(claim, *line.front()) ? " nearest" : "", xml_text(item),
        xml_text(line_words(line, counts)), x, y, kCellSize, kCellSize, x + kCellSize / 2, y + 9.5,
        look.sign);
  }

  const MatrixLook& look_;
  double y_ = 1;
  std::string parts_;
};

/// The matrix of all claims of a run; empty if it tested none.
std::string matrix_svg(const Report& report, const MatrixLook& look) {
  MatrixDrawing drawing(look);
  drawing.heads();
  bool any = false;
  for (const Entry& entry : report.entries) {
    for (const Claim& claim : entry.result.claims) {
      drawing.row(claim, entry.experiment->item);
      any = true;
    }
  }
  return any ? drawing.svg() : std::string();
}

/// What cells mean, each sign once.
std::string key() {
  std::string html =
      "<p class=\"note key-of-cells\">A cell is a reading by a metric on all subjects:";
  for (const CellLook& look : kLooks) {
    html += fmt::format(" <span class=\"cell {}\">{}</span> {}{}", look.css, look.sign, look.words,
                        &look == &kLooks.back() ? "; " : ",");
  }
  return html +
         "a frame marks the reading nearest to the text. A cell leads to its matrix, a claim to "
         "its "
         "words.</p>\n";
}

}  // namespace

std::string claims_overview(const Report& report) {
  const std::string wide = matrix_svg(report, kWide);
  return wide.empty() ? wide
                      : fmt::format(
                            "<h2 id=\"overview\">All claims, reading by reading</h2>\n"
                            "<div class=\"overview\">\n{}{}</div>\n{}",
                            wide, matrix_svg(report, kNarrow), key());
}

}  // namespace soms::reproduce
