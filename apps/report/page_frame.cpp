#include "apps/report/page_frame.h"

#include "soms/base/text.h"

#include "apps/draw/look.h"
#include "apps/draw/page_style.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::report {

namespace {

/// Nothing is fetched, whatever a model's name or a script tries. What a moved body touches is
/// found by WebAssembly in a worker, both of which the page holds.
constexpr std::string_view kPolicy =
    "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; worker-src blob:; "
    "style-src 'unsafe-inline'; img-src data: blob:";

}  // namespace

void write_head(std::ostream& out, const Page& page, std::string_view style) {
  const std::string title = xml_text(page.title);
  out << fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>{}{}{}</style>\n</head>\n"
      "<body>\n<main>\n<div id=\"first\">\n<h1>{}</h1>\n",
      kPolicy, title, look::css_colors(), reproduce::kPageStyle, style, title);
  if (!page.lead.empty()) {
    out << fmt::format("<p class=\"lead\">{}</p>\n", xml_text(page.lead));
  }
}

void write_warnings(std::ostream& out, const Page& page) {
  if (page.warnings.empty()) {
    return;
  }
  out << "<div id=\"warnings\" tabindex=\"0\">\n";
  for (const std::string& warning : page.warnings) {
    out << fmt::format("<p class=\"warn\" role=\"note\"><strong>Warning:</strong> {}</p>\n",
                       xml_text(warning));
  }
  out << "</div>\n";
}

void write_facts(std::ostream& out, const Page& page) {
  out << "<dl class=\"facts\">\n";
  for (const Fact& fact : page.facts) {
    out << fmt::format("<dt>{}</dt><dd>{}</dd>\n", xml_text(fact.name), xml_text(fact.value));
  }
  out << "</dl>\n";
}

void write_folded_facts(std::ostream& out, const Page& page) {
  out << "<details id=\"figures\" class=\"fold\">\n<summary>Figures</summary>\n";
  write_facts(out, page);
  out << "</details>\n";
}

void write_figure(std::ostream& out, const Plot& plot) {
  out << fmt::format(
      "<figure>\n<div class=\"picture\" tabindex=\"0\">\n{}</div>\n"
      "<figcaption>{}</figcaption>\n</figure>\n",
      plot.svg.substr(std::min(plot.svg.find("<svg"), plot.svg.size())), xml_text(plot.caption));
}

void write_notes(std::ostream& out, const Page& page) {
  for (const std::string& note : page.notes) {
    out << fmt::format("<p class=\"note\">{}</p>\n", xml_text(note));
  }
}

void write_pieces(std::ostream& out, std::string_view opening,
                  std::span<const std::string_view> pieces) {
  out << opening;
  for (const std::string_view piece : pieces) {
    out << piece;
  }
  out << "</script>\n";
}

}  // namespace soms::report
