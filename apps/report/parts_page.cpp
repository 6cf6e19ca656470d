#include "apps/report/parts_page.h"

#include "apps/report/asset.h"
#include "apps/report/data_block.h"
#include "apps/report/packed.h"
#include "apps/report/page_frame.h"
#include "apps/report/page_style.h"
#include "apps/report/parts_style.h"
#include "apps/report/script_text.h"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>
#include <utility>

namespace soms::report {

namespace {

constexpr int kBitsOfLines = 12;  ///< of a row's reach

constexpr std::string_view kPartsView =
    R"html(<noscript><p class="warn">Scripts are switched off: the list and the picture are not shown. The figures below
are whole; soms clash -o clashes.csv writes the list as a table.</p></noscript>
<p id="trouble" class="warn" role="alert" hidden></p>
<div id="look" hidden>
<div id="sight">
<div id="stage">
<canvas id="canvas" tabindex="0" role="application" aria-label="The chosen clash; arrow keys turn it, with Shift move it, plus and
minus zoom, Home shows all parts, N and P go to the next and the previous row"></canvas>
<svg id="spots" aria-hidden="true"></svg>
<div id="tools"><button id="whole" type="button">All parts</button><button id="again" type="button">Chosen clash</button>
<button id="previous" type="button">Previous</button><button id="next" type="button">Next</button>
<label><input id="cut" type="checkbox" checked> cut away</label></div>
</div>
<h2 id="picked" aria-live="polite">No clash is chosen</h2>
<p class="note" id="legend"><span class="key moves"></span>first part<span class="key still"></span>second part<span
class="key touch"></span>where their surfaces cross<span class="key rest"></span>other parts, cut away in front of the clash.
One sees through the thicker of the two.</p>
</div>
<div id="beside">
<div id="filters"><input id="find" type="search" placeholder="Find a name, id, file, type or key"
aria-label="Find clashes by name, id, file, type or key" autocomplete="off">
<fieldset id="classes"><legend>Class</legend></fieldset>
<fieldset id="statuses" hidden><legend>Status</legend></fieldset>
<button id="clear" type="button">All rows</button></div>
<p id="pair-filter" hidden></p>
<p id="count" role="status" aria-live="polite"></p>
<div id="table" role="grid" tabindex="0" aria-label="Clashes; up and down choose a row"><div id="head" role="row"></div>
<div id="rows" role="rowgroup"></div></div>
<p class="note" id="table-keys">The worst come first. Click a heading to sort, a row to see it; keys up and down, too.</p>
</div>
</div>
<div id="prints"></div>
</section>
</div>
<p id="drawn" class="note"></p>
<section id="side"><h2>The chosen clash</h2><dl id="details"></dl></section>
<section id="matrix-view" hidden><h2>Which models clash</h2><div id="matrices"></div></section>
)html";

/// Writes one page.
class PartsPageWriter {
 public:
  PartsPageWriter(std::ostream& out, const PartsPage& page, const SceneLimits& limits)
      : out_(out), page_(page), data_(page.parts, limits) {}

  ShownParts write() {
    write_head(out_, page_.page, fmt::format("{}{}", kViewStyle, kPartsStyle));
    write_warnings(out_, page_.page);
    out_ << fmt::format("<section id=\"view\" class=\"clashes{}\">\n",
                        page_.rows == 0 ? " no-list" : "")
         << kPartsView;
    write_folded_facts(out_, page_.page);
    write_notes(out_, page_.page);
    out_ << "</main>\n";
    write_list();
    data_.write(out_);
    write_sights();
    write_lines();
    write_scene_json();
    write_pieces(out_, "<script>", script());
    out_ << "</body>\n</html>\n";
    return data_.shown();
  }

 private:
  void write_list() {
    out_ << "<script type=\"application/json\" id=\"soms-clashes\">{\"schema\":\"soms.clashes/1\","
            "\"totals\":"
         << script_json(page_.totals) << ",\n\"sides\":[";
    for (std::size_t k = 0; k < page_.sides.size(); ++k) {
      out_ << (k == 0 ? "\n" : ",\n") << script_json(page_.sides[k].json);
    }
    out_ << "],\n\"rows\":[";
    for (std::size_t k = 0; k < page_.rows; ++k) {
      PageRow row = page_.row(k);
      out_ << (k == 0 ? "\n" : ",\n") << script_json(row.json);
      if (!row.lines.empty() && row.sight) {
        all_lines_.emplace_back(k, std::move(row.lines));
      }
      sights_.push_back(row.sight);
    }
    out_ << "]}</script>\n";
  }

  void put(Base64Writer& data, const Vec3& v) const {
    for (const double value : {v.x, v.y, v.z}) {
      data.put(static_cast<float>(value));
    }
  }

  void write_sights() const {
    DataBlock block(out_, "sights");
    for (const std::optional<PageSight>& sight : sights_) {
      const PageSight shown =
          sight.value_or(PageSight{.place = data_.origin(), .focus = data_.origin(), .reach = 0});
      put(block.data(), data_.place(shown.place));
      put(block.data(), data_.place(shown.focus));
      block.data().put(static_cast<float>(shown.reach * data_.scale()));
      put(block.data(), shown.toward);
      block.data().put(shown.a_is_larger ? 1.0F : 0.0F);
    }
    block.finish();
  }

  /// For each row that has lines: its number, how many, and their unit; then the lines.
  void write_lines() const {
    DataBlock curves(out_, "curves");
    const auto step = [&](std::size_t row) {
      return step_of(sights_[row]->reach * data_.scale(), kBitsOfLines);
    };
    for (const auto& [row, lines] : all_lines_) {
      curves.data().put(static_cast<std::uint32_t>(row));
      curves.data().put(static_cast<std::uint32_t>(lines.size()));
      curves.data().put(static_cast<float>(step(row)));
    }
    curves.finish();
    DataBlock block(out_, "lines");
    for (const auto& [row, lines] : all_lines_) {
      std::vector<std::array<Vec3, 2>> placed;
      placed.reserve(lines.size());
      for (const auto& [from, to] : lines) {
        placed.push_back({data_.place(from), data_.place(to)});
      }
      put_lines(block.data(), placed, data_.place(sights_[row]->focus), step(row));
    }
    block.finish();
  }

  void write_scene_json() const {
    const auto numbers = [](const Vec3& v) { return fmt::format("[{},{},{}]", v.x, v.y, v.z); };
    const ShownParts& shown = data_.shown();
    out_ << fmt::format(
        "<script type=\"application/json\" id=\"soms-parts-scene\">{{\"schema\":\"soms.parts/1\","
        "\"origin\":{},\"scale\":{},\"half\":{},\"parts\":{},\"all\":{},\"listed\":{},"
        "\"simplified\":{},\"triangles\":{},\"triangles_in_all\":{},\"curves\":{},\"of_sides\":[",
        numbers(data_.origin()), data_.scale(), numbers(data_.half()), shown.parts,
        shown.parts_in_all, shown.listed, shown.simplified, shown.triangles, shown.triangles_in_all,
        all_lines_.size());
    for (std::size_t k = 0; k < page_.sides.size(); ++k) {
      const std::size_t part = page_.sides[k].part;
      const std::uint32_t number = part == kNoPart ? kNoPart : data_.number(part);
      out_ << (k == 0 ? "" : ",") << (number == kNoPart ? -1 : static_cast<std::int64_t>(number));
    }
    out_ << "]}</script>\n";
  }

  std::ostream& out_;
  const PartsPage& page_;
  PartsData data_;
  std::vector<std::optional<PageSight>> sights_;
  std::vector<std::pair<std::size_t, std::vector<std::array<Vec3, 2>>>> all_lines_;
};

}  // namespace

ShownParts write_parts_page(std::ostream& out, const PartsPage& page, const SceneLimits& limits) {
  return PartsPageWriter(out, page, limits).write();
}

}  // namespace soms::report
