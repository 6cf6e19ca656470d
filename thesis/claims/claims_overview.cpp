#include "thesis/claims/claims_overview.h"

#include "soms/base/text.h"

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

std::string cell_of(const Claim& claim, const std::vector<const ClaimRow*>& line,
                    std::string_view item) {
  const LineCounts counts = counts_of(line);
  const CellLook& look = look_of(counts.stand());
  const std::string words = xml_text(line_words(line, counts));
  return fmt::format(
      "<a class=\"cell {}{}\" href=\"#item-{}\" title=\"{}\" aria-label=\"{}\">{}</a>", look.css,
      is_nearest(claim, *line.front()) ? " nearest" : "", xml_text(item), words, words, look.sign);
}

/// The cells of a claim: those of the nearest reading first, the others as in the matrix.
std::string cells_of(const Claim& claim, std::string_view item) {
  std::vector<std::vector<const ClaimRow*>> lines = lines_of(claim);
  std::stable_partition(lines.begin(), lines.end(), [&](const std::vector<const ClaimRow*>& line) {
    return is_nearest(claim, *line.front());
  });
  std::string html;
  for (const std::vector<const ClaimRow*>& line : lines) {
    html += cell_of(claim, line, item);
  }
  return html;
}

std::string verdict_cell(const std::string& badge, const std::string& share) {
  return fmt::format("<td class=\"verdict\">{}<br><span class=\"faint\">{}</span></td>", badge,
                     share);
}

std::string row_of(const Claim& claim, std::string_view item) {
  const NearestVerdict nearest = nearest_of(claim);
  return fmt::format(
      "<tr><td><a href=\"#claim-{}\">{}</a></td>{}{}<td class=\"cells\">{}</td></tr>\n",
      xml_text(claim.id), xml_text(claim.statement),
      verdict_cell(badge(nearest.stand), shares_words(nearest)),
      verdict_cell(badge(verdict_of(claim)), share_words(claim)), cells_of(claim, item));
}

/// What cells mean, each sign once.
std::string key() {
  std::string html = "<p class=\"note key\">A cell is a reading by a metric on all subjects:";
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
  std::string rows;
  for (const Entry& entry : report.entries) {
    for (const Claim& claim : entry.result.claims) {
      rows += row_of(claim, entry.experiment->item);
    }
  }
  return rows.empty() ? rows
                      : fmt::format(
                            "<h2 id=\"overview\">All claims, reading by reading</h2>\n"
                            "<table class=\"overview\">\n<thead><tr><th>claim</th><th>nearest to "
                            "the text</th><th>over all readings</th>"
                            "<th>readings</th></tr></thead>\n<tbody>\n{}</tbody>\n</table>\n{}",
                            rows, key());
}

}  // namespace soms::reproduce
