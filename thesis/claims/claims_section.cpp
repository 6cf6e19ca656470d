#include "thesis/claims/claims_section.h"

#include "soms/base/text.h"

#include "thesis/claims/nearest_verdict.h"
#include "thesis/page/html.h"
#include "thesis/page/page_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::reproduce {

namespace {

/// How a verdict follows, for the reader; the headers of claim.h, nearest_verdict.h and
/// judged_subjects.h have the same rules.
constexpr std::string_view kRule =
    "<p>A claim is read in every way that the thesis leaves open and by every metric that fits its "
    "words. Each row of its matrix is one reading by one metric on one subject, a model or a trip: "
    "a number, the range that the claim demands of it and, where it is measured, its interval of "
    "95 % (seeded bootstrap in two steps, over processes and over their paired rounds of processor "
    "time; a row of fewer than five processes decides nothing). A row holds if all of the interval "
    "lies in the "
    "range, fails if all of it lies outside, and is undecided if it lies across an end. A claim "
    "has "
    "two verdicts.</p>\n"
    "<p><strong>Nearest to the text</strong>: of the readings that take all that the text or a "
    "caption states as it states it, and the rest at the defaults. The share is that of the judged "
    "rows that hold, with its Wilson interval of 95 %: its low end counts the rows that hold, its "
    "high end those that are undecided, too. Rows of one model are not independent draws, so the "
    "interval is at least so wide. The claim <em>holds</em> if every row holds and <em>fails</em> "
    "if every row fails; else it <em>mostly holds</em> if the low end is above one half, "
    "<em>mostly "
    "fails</em> if the high end is below it, is <em>mixed</em> if rows hold and fail, and "
    "<em>undecided</em> otherwise. A comparison on fewer than three subjects or in fewer than "
    "three "
    "rows has <em>too few rows</em>; a figure needs one. Rows that count and rows that measure "
    "time "
    "have a share each, too. If most rows hold in one kind only, the claim is <em>mixed</em>.</p>\n"
    "<p><strong>Over all readings</strong>: the claim <em>holds in all readings</em> if every row "
    "holds; <em>holds under some readings</em> if readings by a metric hold on all their subjects, "
    "with at least three rows together and, for a comparison, three subjects each; <em>holds on "
    "some subjects</em> if rows hold, but too few in such readings; <em>does not hold in any "
    "reading</em> if every row fails; is <em>undecided</em> if no row holds and some are "
    "undecided. Either verdict is <em>cannot be checked</em> if there is no row to judge.</p>\n"
    "<p><strong>What is judged</strong> follows one rule in every claim. A figure, a number that "
    "the thesis states of a model, is judged only on the model that it names, if it is given. A "
    "comparison speaks of models in general and is judged on every model, stand-ins included. Rows "
    "that are left out only because their model is a stand-in are counted beside the verdict. Toy "
    "sets, which this project made to show a picture, are shown and never judged; nor are counts "
    "that follow from construction, such as pairs entered by the family test. Rows that are "
    "shown but not judged say why. Counts are the same in every run. Of measured rows a few in a "
    "hundred may stand otherwise in another run, and more on another machine or with another "
    "compiler.</p>\n";

/// The words of the matrices, for a reader who meets them here first.
constexpr std::string_view kWords =
    "<p><strong>Empty side</strong> is what becomes of a node that a rule cannot divide: with "
    "<em>stop</em> it stays whole, with <em>next_axis</em> the other axes are tried, with "
    "<em>object_median</em> its triangles are halved by number, with <em>chain</em> it gets a "
    "child "
    "without triangles. The <strong>inner axis</strong> is the longest of the box of the "
    "midpoints, "
    "the <strong>outer axis</strong> that of the box of the triangles. <strong>E-Node</strong> may "
    "be a <em>family test</em> (all child pairs are tested before one is entered), a start "
    "<em>from "
    "the last front</em> (where the frame before ended), or going on down <em>while one child "
    "overlaps</em>. <em>Larsson's</em> traversal descends both nodes at once, <em>Ericson's</em> "
    "the "
    "larger one. In an <strong>orientation test</strong> an object comes at its like from one "
    "side; "
    "in a <strong>drive</strong> it moves through a scene, in a <strong>touching drive</strong> "
    "along a line on which it touches in about half of the frames. <strong>(ours)</strong> marks "
    "what the thesis does not state.</p>\n";

/// Marks of a row for those who cannot tell colors apart.
std::string_view mark_of(const ClaimRow& row) {
  switch (stand_of(row)) {
    case Verdict::holds:
      return "&#10003;";
    case Verdict::undecided:
      return "&#177;";
    case Verdict::does_not_hold:
      return "&#10007;";
    default:
      return "&#8211;";
  }
}

std::string cell_of(const std::vector<const ClaimRow*>& line, const std::string& subject) {
  const auto row = std::find_if(line.begin(), line.end(),
                                [&](const ClaimRow* one) { return one->subject == subject; });
  if (row == line.end()) {
    return "<td></td>";
  }
  return fmt::format("<td class=\"number {}{}\"{}>{} {}</td>", class_of(stand_of(**row)),
                     (*row)->interval ? " timed" : "",
                     (*row)->unjudged.empty()
                         ? std::string()
                         : fmt::format(" title=\"{}\"", xml_text((*row)->unjudged)),
                     mark_of(**row), xml_text(words_of(**row)));
}

std::string matrix_of(const Claim& claim) {
  const std::vector<std::string> subjects = subjects_of(claim);
  std::string html = fmt::format(
      "<div class=\"scroll tall\" tabindex=\"0\" role=\"region\" aria-label=\"Matrix: {}\">\n"
      "<table class=\"matrix\">\n<thead><tr><th>metric</th><th>reading</th><th>demanded</th>",
      xml_text(claim.statement));
  for (const std::string& subject : subjects) {
    html += fmt::format("<th class=\"number\">{}</th>", xml_text(subject));
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const std::vector<const ClaimRow*>& line : lines_of(claim)) {
    html += fmt::format("<tr><td>{}</td><td>{}</td><td class=\"short\">{}</td>",
                        xml_text(line[0]->metric), xml_text(line[0]->reading),
                        xml_text(words_of(line[0]->demand)));
    for (const std::string& subject : subjects) {
      html += cell_of(line, subject);
    }
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n</div>\n";
}

/// A claim with the experiment that tested it.
using Tested = std::pair<const Claim*, const Experiment*>;

std::vector<Tested> tested_claims(const Report& report) {
  std::vector<Tested> tested;
  for (const Entry& entry : report.entries) {
    for (const Claim& claim : entry.result.claims) {
      tested.emplace_back(&claim, entry.experiment);
    }
  }
  return tested;
}

/// Sentences about rows that are shown and not judged, each reason once.
std::string unjudged_words(const Claim& claim) {
  std::vector<std::string> reasons;
  for (const ClaimRow& row : claim.rows) {
    if (!row.unjudged.empty() &&
        std::find(reasons.begin(), reasons.end(), row.unjudged) == reasons.end()) {
      reasons.push_back(row.unjudged);
    }
  }
  std::string html;
  for (const std::string& reason : reasons) {
    html += fmt::format("<p>Shown, not judged (&#8211;): {}</p>\n", xml_text(sentence(reason)));
  }
  return html;
}

/// Those that are not empty, one after the other.
std::string joined_sentences(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& one : sentences) {
    text += fmt::format("{}{}", text.empty() || one.empty() ? "" : " ", one);
  }
  return text;
}

/// A claim in words, folded below its statement and its verdict.
std::string in_words(const Tested& tested) {
  const auto& [claim, experiment] = tested;
  const NearestVerdict nearest = nearest_of(*claim);
  // The anchor is inside, so that a link to it unfolds the claim.
  return fmt::format(
      "<details class=\"item claim\">\n<summary>{} <h3>{}</h3> <span "
      "class=\"faint\">({})</span></summary>\n<div class=\"anchor\" id=\"claim-{}\"></div>\n"
      "<p>{}{} {}</p>\n<p>Over all readings: {} {}. {}</p>\n<p><a href=\"#item-{}\">Matrix of {}, "
      "and why</a></p>\n</details>\n",
      badge(nearest.stand), xml_text(claim->statement), xml_text(claim->source),
      xml_text(claim->id), shares_words(nearest), shares_words(nearest).empty() ? "" : ".",
      xml_text(words_of(nearest)), badge(verdict_of(*claim)), share_words(*claim),
      xml_text(joined_sentences({where(*claim), stand_in_words(*claim), claim->note})),
      xml_text(experiment->item), counted(claim->rows.size(), "row"));
}

/// How many claims have each verdict: "3 [holds], 2 [mixed]".
template <typename Stand, std::size_t kCount, typename StandOf>
std::string tally(const std::vector<Tested>& claims, const StandOf& stand_of_claim) {
  std::array<std::size_t, kCount> counts = {};
  for (const Tested& tested : claims) {
    ++counts.at(static_cast<std::size_t>(stand_of_claim(*tested.first)));
  }
  std::string html;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts.at(k) > 0) {
      html += fmt::format("{}{} {}", html.empty() ? "" : ", ", counts.at(k),
                          badge(static_cast<Stand>(k)));
    }
  }
  return html;
}

std::string tallies(const std::vector<Tested>& claims) {
  return fmt::format(
      "<p>{}. Nearest to the text: {}. Over all readings: {}.</p>\n",
      counted(claims.size(), "claim"),
      tally<NearestStand, kNearestStandCount>(
          claims, [](const Claim& claim) { return nearest_of(claim).stand; }),
      tally<Verdict, kVerdictCount>(claims, [](const Claim& claim) { return verdict_of(claim); }));
}

/// How the first edition of the page named a verdict.
std::string_view name_before(Verdict verdict) {
  return verdict == Verdict::holds         ? "holds"
         : verdict == Verdict::holds_under ? "holds under options"
                                           : "does not hold";
}

/// The paragraph on verdicts that are not what they were.
std::string revisions(const std::vector<Tested>& claims) {
  std::string html;
  for (const auto& [claim, experiment] : claims) {
    const std::optional<Revision>& revision = claim->revision;
    if (revision && revision->before != verdict_of(*claim)) {
      html += fmt::format(
          " <a href=\"#claim-{}\">{}</a>: was &#8220;{}&#8221;, is "
          "&#8220;{}&#8221;, for {}",
          xml_text(claim->id), xml_text(claim->statement), name_before(revision->before),
          name(verdict_of(*claim)), xml_text(sentence(revision->reason)));
    }
  }
  return html.empty() ? html
                      : fmt::format(
                            "<p class=\"changed\"><strong>Verdicts that are not those of the "
                            "first edition of this page.</strong>{}</p>\n",
                            html);
}

}  // namespace

std::string claim_part(const Claim& claim, PageFiles files) {
  const NearestVerdict nearest = nearest_of(claim);
  std::string html = fmt::format(
      "<p><strong>{}</strong> <span class=\"faint\">({})</span></p>\n<p>{} {}</p>\n"
      "<p>Over all readings: {} {}</p>\n",
      xml_text(sentence(claim.statement)), xml_text(claim.source), badge(nearest.stand),
      xml_text(words_of(nearest)), badge(verdict_of(claim)),
      xml_text(joined_sentences({where(claim), stand_in_words(claim)})));
  if (!claim.note.empty()) {
    html += fmt::format("<p>{}</p>\n", xml_text(claim.note));
  }
  if (!claim.why.empty()) {
    html += fmt::format("<p>{}</p>\n", xml_text(claim.why));
  }
  if (!claim.settles.empty()) {
    html += fmt::format("<p><strong>What would settle it:</strong> {}</p>\n",
                        xml_text(sentence(claim.settles)));
  }
  html += unjudged_words(claim);
  if (claim.rows.empty()) {
    return html;
  }
  if (files == PageFiles::paper) {
    return html + markup_of(matrix_table(claim), files, claim_table(claim));
  }
  return html + matrix_of(claim) + file_note(claim_table(claim), files);
}

std::string claims_section(const Report& report) {
  const std::vector<Tested> claims = tested_claims(report);
  std::string html = "<h2 id=\"claims\">What the thesis claims, and how it stands</h2>\n";
  if (claims.empty()) {
    return html + "<p>None of the experiments of this run tests a claim of the thesis.</p>\n";
  }
  html += tallies(claims) + revisions(claims);
  html += fmt::format(
      "<details>\n<summary>How a verdict follows, and what the words mean</summary>\n"
      "{}{}</details>\n",
      kRule, kWords);
  for (const Tested& tested : claims) {
    html += in_words(tested);
  }
  return html +
         "<p class=\"note\">Times are in italics: they differ from "
         "run to run and from machine to machine.</p>\n";
}

}  // namespace soms::reproduce
