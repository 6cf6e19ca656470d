#include "soms/base/text.h"

#include "apps/draw/look.h"
#include "apps/draw/page_style.h"
#include "thesis/claims/claims_overview.h"
#include "thesis/claims/claims_section.h"
#include "thesis/claims/research_questions.h"
#include "thesis/page/html.h"
#include "thesis/page/page_table.h"
#include "thesis/page/paper.h"
#include "thesis/page/print_style.h"
#include "thesis/page/report.h"
#include "thesis/run/provenance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr std::array<std::pair<Chapter, std::string_view>, 3> kChapterTitles{
    {{Chapter::claims, "The claims, one by one"},
     {Chapter::thesis, "Tables and figures of the thesis"},
     {Chapter::beyond, "Beyond the thesis"}}};

/// A drawing as part of the page: what precedes its root is dropped, and its ids, if any, are made
/// the figure's own.
std::string inlined(const Figure& figure) {
  std::string svg = figure.svg.substr(std::min(figure.svg.find("<svg"), figure.svg.size()));
  for (const std::string_view key : {" id=\"", "url(#", "href=\"#"}) {
    const std::string own = "f-" + figure.id + "-";
    for (std::size_t at = svg.find(key); at != std::string::npos; at = svg.find(key, at)) {
      at += key.size();
      svg.insert(at, own);
    }
  }
  return svg;
}

/// Bytes of the drawings that are part of a page with files beside it. Pictures of whole models are
/// larger, and would make it several megabytes that most readers never unfold.
constexpr std::size_t kMostInlined = std::size_t{10} << 10U;

/// A drawing as the page has it: its markup or, if it is large and lies beside the page, its file.
std::string drawing_of(const Figure& figure, PageFiles files) {
  return files == PageFiles::beside && figure.svg.size() > kMostInlined
             ? fmt::format("<img src=\"{}\" alt=\"\" loading=\"lazy\">\n",
                           xml_text(file_of(figure).generic_string()))
             : inlined(figure);
}

/// True if a table is the matrix of a claim, which the page shows with the claim.
bool is_matrix(const Table& table, const Result& result) {
  return std::any_of(result.claims.begin(), result.claims.end(),
                     [&](const Claim& claim) { return table.id == "claim_" + claim.id; });
}

/// Writes the page section by section.
class Page {
 public:
  Page(const Report& report, PageFiles files) : report_(report), files_(files) {}

  std::string write() {
    head();
    out_ += claims_overview(report_);
    out_ += load_warning(report_.load);
    in_todays_terms();
    out_ += questions_section(report_);
    out_ += claims_section(report_);
    contents();
    how_it_was_run();
    out_ += report_.golden ? markup_of(*report_.golden) : std::string();
    models();
    for (const auto& [which, title] : kChapterTitles) {
      chapter(which, title);
    }
    out_ += "</main>\n</body>\n</html>\n";
    return std::move(out_);
  }

 private:
  template <typename... Values>
  void put(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(out_), form, std::forward<Values>(values)...);
  }

  void head() {
    put("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>SOMS: the experiments of the thesis, run again</title>\n<link rel=\"icon\" "
        "href=\"data:,\">\n"
        "<style>{}{}{}</style>\n</head>\n<body>\n<main>\n<header class=\"title\">\n<h1>SOMS: the "
        "experiments of the thesis, run again</h1>\n",
        look::css_colors(), kPageStyle, files_ == PageFiles::paper ? kPaperStyle : kPrintStyle);
    put("<p class=\"lead\">Tables and figures of <cite>Spatial object median rules in bounding-"
        "volume hierarchies for complex environments</cite> (Hamzah Asyrani bin Sulaiman, master's "
        "thesis, Universiti Teknologi Malaysia, 2010), run again by the program <code>soms</code>, "
        "and each claim of the thesis beside what was measured.</p>\n");
    put("<p class=\"byline\">soms {}, {} run of {}</p>\n</header>\n",
        xml_text(report_.machine.version), report_.quick ? "quick" : "full",
        xml_text(report_.date.substr(0, report_.date.find('T'))));
  }

  /// What a reader may want to know first, folded: the picture of all claims stands above it.
  void in_todays_terms() {
    put("<details>\n<summary>What SOMS is in today's terms, and what follows without any "
        "run</summary>\n");
    put("<p class=\"note\">Only its abstract, lists of contents, tables and figures, and first "
        "chapter were available to us: the numbers of its tables are not known here, and what they "
        "leave open is an option with a name.</p>\n");
    put("<p><strong>SOMS in today's terms</strong> is midpoint splitting of the box of the "
        "triangles' midpoints: a node is cut in the middle of that box, across its longest axis. "
        "Renderers know the same plane as the <em>middle</em> of the <em>centroid bounds</em>. "
        "What is particular to the thesis is the midpoint: halfway between corner C and the middle "
        "of A and B, which is not the centroid and depends on the order of the corners. It cuts "
        "wherever two midpoints differ, so it needs no fallback where spatial median, which cuts "
        "the box of the triangles themselves, gets stuck; given levels enough, only "
        "triangles of one midpoint stay together.</p>\n");
    put("<p><strong>Two things follow without any run.</strong> Object median gives half of the "
        "triangles to each side, so no rule balances better{}. And E-Node, in the "
        "reading nearest to its captions, tests the same pairs of boxes as a traversal that "
        "descends "
        "both trees at once, in another order{}: what it can save is entering pairs, not testing "
        "them.</p>\n</details>\n",
        reference("balance"), reference("figure-5.10"));
  }

  /// " (Figure 5.10)" as a link, where the run has this item.
  [[nodiscard]] std::string reference(std::string_view item) const {
    const bool there = std::any_of(report_.entries.begin(), report_.entries.end(),
                                   [&](const Entry& e) { return e.experiment->item == item; });
    return there ? fmt::format(" (<a href=\"#item-{}\">{}</a>)", item, spoken(item)) : "";
  }

  void how_it_was_run() {
    put("<h2 id=\"run\">This run</h2>\n");
    out_ += run_facts(report_);
    if (report_.quick) {
      put("<p class=\"warn\"><strong>Quick run.</strong> Counts of the thesis' own tables are "
          "those "
          "of a whole run; times are medians of few repetitions.</p>\n");
    }
    if (!report_.missing.empty()) {
      put("<p class=\"warn\"><strong>This run was interrupted.</strong> {} of {} did not run:",
          report_.missing.size(),
          counted(report_.missing.size() + report_.entries.size(), "experiment"));
      for (const Experiment* experiment : report_.missing) {
        put(" <a href=\"#item-{0}\">{0}</a>{1}", xml_text(experiment->item),
            experiment == report_.missing.back() ? "." : ",");
      }
      put("</p>\n");
    }
    if (files_ == PageFiles::paper) {
      put("<p class=\"note\">Beside it this run wrote a CSV file of each table, with all rows, an "
          "SVG file of each figure, and <code>run.json</code>, which lists them; their names are "
          "given below.</p>\n");
    } else if (files_ == PageFiles::inside) {
      put("<p class=\"note\">This page needs no other file: a link below each table gives it as "
          "CSV.</p>\n");
    } else {
      put("<p class=\"note\">The same folder has a CSV file of each table, an SVG file of each "
          "figure and <a href=\"run.json\">run.json</a>, which lists them.</p>\n");
    }
  }

  void models() {
    const std::size_t count =
        report_.models.objects.size() + report_.models.scenes.size() + report_.models.cities.size();
    if (count == 0) {
      return;
    }
    put("<h2 id=\"models\">Models</h2>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
        "aria-label=\"Models\">\n<table>\n<thead><tr><th>model</th><th>from</th>"
        "<th class=\"number\">vertices</th><th class=\"number\">triangles</th>"
        "<th>hash of the corners</th><th>remarks</th></tr></thead>\n<tbody>\n");
    for (const auto* kind :
         {&report_.models.objects, &report_.models.scenes, &report_.models.cities}) {
      for (const Model& model : *kind) {
        put_model(model);
      }
    }
    put("</tbody>\n</table>\n</div>\n");
    out_ += model_files(report_.models);
    for (const std::string& remark : report_.models.remarks) {
      put("<p class=\"note\">{}</p>\n", xml_text(remark));
    }
  }

  void put_model(const Model& model) {
    put("<tr><td>{}</td><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>"
        "<td><code>{:016x}</code></td><td>{}{}{}</td></tr>\n",
        xml_text(model.title.empty() ? model.name : model.title),
        model.file.empty() ? "generated" : xml_text(model.file),
        to_text(static_cast<std::int64_t>(model.mesh->vertices.size())),
        to_text(static_cast<std::int64_t>(model.mesh->triangles.size())), model.hash,
        model.stand_in ? "<span class=\"mark\">stand-in</span> not the model of the thesis" : "",
        model.stand_in && !model.trouble.empty() ? "<br>" : "",
        model.trouble.empty() ? std::string()
                              : "<span class=\"mark\">trouble</span> " + xml_text(model.trouble));
  }

  [[nodiscard]] bool has(Chapter which) const {
    return std::any_of(report_.entries.begin(), report_.entries.end(),
                       [&](const Entry& e) { return e.experiment->chapter == which; }) ||
           std::any_of(report_.missing.begin(), report_.missing.end(),
                       [&](const Experiment* e) { return e->chapter == which; });
  }

  void contents() {
    put("<h2 id=\"contents\">Contents</h2>\n<nav aria-label=\"Contents\">\n");
    for (const auto& [which, title] : kChapterTitles) {
      if (!has(which)) {
        continue;
      }
      put("<b>{}</b>\n<ul>\n", title);
      const auto row = [&, chapter = which](const Experiment& experiment, std::string_view mark) {
        if (experiment.chapter == chapter) {
          put("<li><a href=\"#item-{}\">{}</a>: {}{}</li>\n", xml_text(experiment.item),
              xml_text(spoken(experiment.item)), xml_text(experiment.title), mark);
        }
      };
      for (const Entry& entry : report_.entries) {
        row(*entry.experiment, "");
      }
      for (const Experiment* experiment : report_.missing) {
        row(*experiment, " <span class=\"mark\">not run</span>");
      }
      put("</ul>\n");
    }
    put("</nav>\n");
  }

  void chapter(Chapter which, std::string_view title) {
    if (!has(which)) {
      return;
    }
    put("<h2>{}</h2>\n", title);
    for (const Entry& entry : report_.entries) {
      if (entry.experiment->chapter == which) {
        put_entry(entry);
      }
    }
    for (const Experiment* experiment : report_.missing) {
      if (experiment->chapter == which) {
        heading(*experiment);
        put("<p class=\"warn\">Not run: the run was interrupted first. "
            "<code>soms reproduce --item {}</code> runs it alone.</p>\n</details>\n</section>\n",
            xml_text(experiment->item));
      }
    }
  }

  void heading(const Experiment& experiment) {
    // The anchor is inside, so that a link to it unfolds the item.
    put("<section>\n<details class=\"item\">\n<summary><h3>{1}. {2}</h3></summary>\n"
        "<div class=\"anchor\" id=\"item-{0}\"></div>\n",
        xml_text(experiment.item), xml_text(spoken(experiment.item)), xml_text(experiment.title));
  }

  void put_entry(const Entry& entry) {
    heading(*entry.experiment);
    put("<p class=\"note\"><code>soms reproduce --item {}</code> ran {}</p>\n",
        xml_text(entry.experiment->item),
        entry.seconds < 0.1 ? std::string("less than 0.1 s")
                            : fmt::format("{:.1f} s", entry.seconds));
    for (const Claim& claim : entry.result.claims) {
      out_ += claim_part(claim, files_);
    }
    for (const Figure& figure : entry.result.figures) {
      put_figure(figure);
    }
    for (const std::string& remark : entry.result.remarks) {
      put("<p>{}</p>\n", xml_text(remark));
    }
    for (const Table& table : entry.result.tables) {
      if (!is_matrix(table, entry.result)) {
        out_ += markup_of(table, files_);
      }
    }
    put("</details>\n</section>\n");
  }

  void put_figure(const Figure& figure) {
    const std::string link =
        files_ == PageFiles::inside
            ? std::string()
            : fmt::format("<a href=\"{}\">SVG</a>", xml_text(file_of(figure).generic_string()));
    put("<figure id=\"f-{}\">\n<div class=\"picture\" tabindex=\"0\" role=\"img\" "
        "aria-label=\"{}\">\n{}</div>\n<figcaption>{} {}{}</figcaption>\n"
        "</figure>\n",
        xml_text(figure.id), xml_text(figure.alt.empty() ? figure.caption : figure.alt),
        drawing_of(figure, files_), xml_text(figure.caption),
        figure.timed ? "<em>Times: differ from run to run.</em> " : "", link);
  }

  const Report& report_;
  PageFiles files_;
  std::string out_;
};

}  // namespace

std::string page(const Report& report, PageFiles files) {
  std::string html = Page(report, files).write();
  return files == PageFiles::paper ? opened_for_paper(html) : html;
}

}  // namespace soms::reproduce
