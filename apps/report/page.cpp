#include "apps/report/page.h"

#include "soms/base/text.h"

#include "apps/report/asset.h"
#include "apps/report/page_frame.h"
#include "apps/report/page_style.h"
#include "apps/report/time_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace soms::report {

namespace {

/// Tables with more rows are folded.
constexpr std::size_t kMostOpenRows = 12;

constexpr std::string_view kStage =
    R"html(<noscript><p class="warn">Scripts are switched off: the scene is not drawn. Figures and pictures below
are whole.</p></noscript>
<div id="look" hidden>
<div id="sight">
<div id="stage">
<canvas id="canvas" tabindex="0" role="application" aria-label="The scene with its contacts; arrow keys
turn it, plus and minus come closer and go away, N and P go to the next and the previous row of the list"></canvas>
<svg id="spots" aria-hidden="true"></svg>
<svg id="gaps" class="gaps" aria-hidden="true"></svg>
<svg id="live-gap" class="gaps" aria-hidden="true"></svg>
<p id="trouble" class="warn" role="alert" hidden></p>
<div id="tools"><button id="whole" type="button">Whole scene</button>
<button id="above" type="button">From above</button>
<button id="move" type="button" aria-pressed="false" hidden>Move a body</button>
<button id="reset" type="button" hidden>Reset</button>
<span id="within" hidden><button id="earlier" type="button" aria-label="Previous contact of the event" title="Key ,">&#8249;</button>
<span id="which"></span><button id="later" type="button" aria-label="Next contact of the event" title="Key .">&#8250;</button></span></div>
<p id="missing" hidden></p>
<details id="keys"><summary>Keys</summary><div>Drag: turn. Right button, or two fingers: move. Wheel,
after a click on the picture: zoom in and out. Click a marker or a gap: show what touches or is near there. Arrows: turn, with Shift
move. + and -: zoom in and out. Home: the whole scene. N, P: next and previous row of the list. Point, comma: next and
previous contact of the row. Space: play, pause. In the list: arrow keys choose, Right and Left open and close a row.<span id="move-keys" hidden> M: move a
body, or stop. Then drag a body: along the ground; with Shift: up and down. Arrows, Page Up and Page Down move it, Q and E turn it about
the vertical, W and S, A and D tilt it; with Shift a tenth as far. R: back to its recorded pose.</span></div></details>
</div>
)html";

constexpr std::string_view kList = R"html(<div id="side">
<div class="row"><input id="find" type="search" placeholder="Find a name, part or triangle"
aria-label="Find contacts by name, part or triangle number" autocomplete="off">
<select id="order" aria-label="Order of the list"><option value="most">most first</option>
<option value="begin">by begin</option><option value="count">most contacts first</option><option value="length">longest first</option>
<option value="mover">by what touches</option><option value="touched">by what is touched</option></select>
<label><input id="now" type="checkbox"> only now</label></div>
<p id="count" role="status"></p>
<div id="list" role="tree" tabindex="0" aria-label="List of contacts">)html";

/// The lines of either list.
constexpr std::string_view kLines =
    R"html(<div id="rows"
role="presentation"></div></div>
<div class="row"><button id="previous" type="button">Previous</button>
<button id="next" type="button">Next</button></div>
</div>
)html";

constexpr std::string_view kAnswers = R"html(<p id="picked" role="status" aria-live="polite"></p>
<div id="live" hidden><p id="live-answer" role="status" aria-live="polite"></p>
<p class="note"><span id="live-where"></span> <code id="live-pose"></code></p><p id="live-others" class="note"></p></div>
<p id="no-live" class="note" hidden></p>
)html";

constexpr std::string_view kTime =
    R"html(<div id="time"><button id="play" type="button">Play</button>
<input id="step" type="range" min="0" max="0" step="1" value="0" aria-label="Time">
<output id="moment" for="step"></output></div>
)html";

/// Ends what stands at the left.
constexpr std::string_view kLegend =
    R"html(<p class="note" id="legend"><span class="key moves"></span>moves<span class="key still"></span>what it touches<span class="around" hidden><span
class="key rest"></span>all else</span><span class="touching">
<span class="key touch"></span>touches now <span class="key was"></span>touches at another time</span><span id="near" hidden><span class="key gap"></span>gap: a shortest segment with
its length<span id="near-time"> (dashed: at another time)</span></span></p>
</div>
)html";

constexpr std::string_view kDrawn = R"html(<div id="prints"></div>
</section>
</div>
<p id="drawn" class="note"></p>
)html";

/// In place of `kList` and `kTime` where the page is about motions.
constexpr std::string_view kMotionList = R"html(<div id="side">
<div class="row"><label><input id="blocked" type="checkbox"> only those that are not free</label></div>
<p id="count" role="status"></p>
<div id="list" role="tree" tabindex="0" aria-label="List of motions">)html";

constexpr std::string_view kWay =
    R"html(<div id="time"><button id="play" type="button">Play</button>
<div id="way"><input id="part" type="range" min="0" max="1" step="0.001" value="0" aria-label="Part of the way">
<div id="track" aria-hidden="true"><span id="before"></span><span id="open"></span><span id="after"></span>
<span id="meets"></span></div></div>
<output id="moment" for="part"></output>
<button id="contact" type="button" title="Key C">To the contact</button></div>
)html";

constexpr std::string_view kWayLegend =
    R"html(<p class="note" id="legend"><span class="key moves"></span>A, before the contact<span class="blocking"><span
class="key was"></span>A, after it<span class="key touch"></span>the contact</span><span class="key still"></span>B.
Pale: A at the start, at the contact and at the end.</p>
</div>
)html";

/// Writes one page.
class PageWriter {
 public:
  PageWriter(std::ostream& out, const Page& page, const SceneLimits& limits)
      : out_(out), page_(page), limits_(limits) {}

  Shown write() {
    write_head(out_, page_, kViewStyle);
    write_warnings(out_, page_);
    out_ << fmt::format("<section id=\"view\"{}>\n", kind_of_view()) << kStage
         << (of_motions() ? kWay : kTime) << kAnswers << (of_motions() ? kWayLegend : kLegend);
    // Scripts know the list, even where it has nothing to show.
    out_ << "<div id=\"beside\">\n"
         << (of_motions() ? kMotionList : kList) << kLines << "</div>\n</div>\n";
    answer();
    out_ << kDrawn;
    line_of_time();
    if (page_.beside.empty()) {
      write_folded_facts(out_, page_);
    }
    tables();
    plots();
    write_notes(out_, page_);
    out_ << "</main>\n";
    const Shown shown = write_scene(out_, page_.scene, limits_,
                                    [this] { write_pieces(out_, "<script>", script()); });
    if (shown.is_live) {
      write_pieces(out_, "<script type=\"text/plain\" id=\"soms-module\">", live_module());
    }
    out_ << "</body>\n</html>\n";
    return shown;
  }

 private:
  [[nodiscard]] bool of_motions() const { return !page_.scene.motions.empty(); }

  /// True where the page has a list: of motions, if there are several, or of what touches.
  [[nodiscard]] bool has_list() const {
    return of_motions() ? page_.scene.motions.size() > 1
                        : page_.scene.lists_contacts && !page_.scene.rows.empty();
  }

  /// The class attribute: what is listed, and whether plots stand beside the scene.
  [[nodiscard]] std::string kind_of_view() const {
    return fmt::format(" class=\"{}{}{}\"", of_motions() ? "motions" : "touches",
                       has_list() ? "" : " no-list", page_.beside.empty() ? "" : " has-plot");
  }

  /// Plots that are the answer, with the figures. They are there without scripts, and on paper.
  void answer() {
    if (page_.beside.empty()) {
      return;
    }
    out_ << "<div id=\"answer\">\n";
    for (const Plot& plot : page_.beside) {
      write_figure(out_, plot);
    }
    write_facts(out_, page_);
    out_ << "</div>\n";
  }

  void line_of_time() {
    const std::string svg = of_motions() ? "" : time_line(page_.scene);
    if (!svg.empty()) {
      out_ << "<section id=\"time-line\">\n<h2>Time line</h2>\n";
      write_figure(
          out_,
          {.svg = svg,
           .caption = fmt::format(
               "The contacts of the bodies that touch something for the longest time{}. Click a "
               "bar to show its contact in the scene.",
               page_.scene.contacts.size() < page_.scene.contacts_in_all
                   ? fmt::format(", drawn from the {} of {} {} that this page holds",
                                 page_.scene.contacts.size(), page_.scene.contacts_in_all,
                                 page_.scene.contact.many)
                   : std::string())});
      out_ << "</section>\n";
    }
  }

  void row(const std::vector<std::string>& texts, const char* tag, std::string_view link = {}) {
    out_ << "<tr>";
    for (const std::string& text : texts) {
      const bool leads = !link.empty() && &text == &texts.front();
      out_ << (leads ? fmt::format("<{0}><a href=\"#{2}\">{1}</a></{0}>", tag, xml_text(text), link)
                     : fmt::format("<{0}>{1}</{0}>", tag, xml_text(text)));
    }
    out_ << "</tr>\n";
  }

  void tables() {
    for (const Table& table : page_.tables) {
      out_ << fmt::format(
          "<details class=\"fold\"{}>\n<summary>{}</summary>\n<div class=\"picture\" "
          "tabindex=\"0\">\n<table>\n<thead>",
          table.rows.size() > kMostOpenRows ? "" : " open", xml_text(table.title));
      row(table.columns, "th");
      out_ << "</thead>\n<tbody>\n";
      const std::size_t links = table.of_gaps      ? std::min(page_.scene.gaps.size(), limits_.gaps)
                                : table.of_motions ? page_.scene.motions.size()
                                                   : 0;
      for (std::size_t k = 0; k < table.rows.size(); ++k) {
        row(table.rows[k], "td",
            k >= links      ? std::string()
            : table.of_gaps ? fmt::format("gap={}", k)
                            : fmt::format("motion={}", page_.scene.motions[k].number));
      }
      out_ << fmt::format("</tbody>\n</table>\n</div>\n<p class=\"note\">{}</p>\n</details>\n",
                          xml_text(table.caption));
    }
  }

  void plots() {
    if (page_.plots.empty()) {
      return;
    }
    out_ << "<section>\n<h2>Plots</h2>\n<div id=\"plots\">\n";
    for (const Plot& plot : page_.plots) {
      write_figure(out_, plot);
    }
    out_ << "</div>\n</section>\n";
  }

  std::ostream& out_;
  const Page& page_;
  const SceneLimits& limits_;
};

}  // namespace

Shown write_page(std::ostream& out, const Page& page, const SceneLimits& limits) {
  return PageWriter(out, page, limits).write();
}

}  // namespace soms::report
