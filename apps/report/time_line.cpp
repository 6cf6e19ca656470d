#include "apps/report/time_line.h"

#include "apps/draw/axis.h"
#include "apps/draw/look.h"
#include "apps/draw/svg.h"
#include "apps/report/script_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

namespace soms::report {

namespace {

using reproduce::Anchor;
using reproduce::Svg;

constexpr double kWidth = 960;
constexpr double kLeft = 190;
constexpr double kRight = 24;
constexpr double kTop = 78;
constexpr double kRow = 20;
constexpr double kBar = 12;
constexpr double kThinnest = 2;
constexpr std::size_t kLongestName = 24;

/// Contacts of a body that overlap or follow each other, as one bar.
struct Bar {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
  std::size_t contact = 0;  ///< the first
  bool moving = false;      ///< with a body that moves too
};

struct Row {
  std::uint32_t body = 0;
  std::uint64_t steps = 0;    ///< in which it touches anything
  std::uint64_t counted = 0;  ///< steps before this one are counted
  std::vector<Bar> bars;
};

/// Adds a contact to a row; contacts come in order of their begin.
void add(Row& row, const Bar& bar) {
  const std::uint64_t first = std::max(bar.begin, row.counted);
  if (bar.end >= first) {
    row.steps += bar.end - first + 1;
    row.counted = bar.end + 1;
  }
  const auto last = std::find_if(row.bars.rbegin(), row.bars.rend(),
                                 [&](const Bar& b) { return b.moving == bar.moving; });
  if (last != row.bars.rend() && bar.begin <= last->end + 1) {
    last->end = std::max(last->end, bar.end);
    return;
  }
  row.bars.push_back(bar);
}

std::vector<Row> rows_of(const Scene& scene, std::size_t most) {
  std::map<std::uint32_t, Row> by_body;
  for (std::size_t k = 0; k < scene.contacts.size(); ++k) {
    const SceneContact& contact = scene.contacts[k];
    const bool both = scene.bodies[contact.a].moves && scene.bodies[contact.b].moves;
    for (const std::uint32_t body : {contact.a, contact.b}) {
      if (body == contact.a || both) {
        add(by_body.try_emplace(body, Row{.body = body, .bars = {}}).first->second,
            {.begin = contact.begin, .end = contact.end, .contact = k, .moving = both});
      }
    }
  }
  std::vector<Row> rows;
  rows.reserve(by_body.size());
  for (auto& [body, row] : by_body) {
    rows.push_back(std::move(row));
  }
  if (rows.size() > most) {
    std::stable_sort(rows.begin(), rows.end(),
                     [](const Row& a, const Row& b) { return a.steps > b.steps; });
    rows.resize(most);
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return a.bars.front().begin < b.bars.front().begin;
  });
  return rows;
}

/// Draws rows.
class Drawing {
 public:
  Drawing(const Scene& scene, std::size_t rows)
      : scene_(scene),
        bottom_(kTop + kRow * static_cast<double>(rows)),
        axis_({.low = 0, .high = static_cast<double>(scene.steps.count), .whole = true}),
        svg_(kWidth, bottom_ + 30, "What touches something, and when") {}

  std::string draw(const std::vector<Row>& rows) {
    key();
    for (const reproduce::Tick& tick : axis_.ticks()) {
      const double at = x(tick.value);
      svg_.line({at, kTop - 4}, {at, bottom_},
                "class=\"grid\"  stroke=\"" + look::hex(look::kLine.light) + "\"");
      svg_.text({at, kTop - 10}, tick.label, {.size = 12, .anchor = Anchor::middle, .faint = true});
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
      row(rows[k], kTop + kRow * static_cast<double>(k));
    }
    svg_.text({0.5 * (kLeft + kWidth - kRight), bottom_ + 20}, scene_.steps.noun + ", from 0",
              {.size = 12, .anchor = Anchor::middle, .faint = true});
    return svg_.document();
  }

 private:
  [[nodiscard]] double x(double step) const {
    return kLeft + axis_.share(step) * (kWidth - kLeft - kRight);
  }

  void key() {
    svg_.text({16, 26}, "What touches something, and when", {.size = 16, .bold = true});
    const auto entry = [&](double at, bool moving, std::string_view words) {
      svg_.rect({at, 38}, 16, kBar, color(moving));
      svg_.text({at + 22, 48}, words, {.size = 12, .faint = true});
    };
    entry(kLeft, false, "with static bodies");
    entry(kLeft + 190, true, "with other movers");
  }

  static std::string color(bool moving) {
    // Sand alone is too pale a mark upon paper.
    return moving ? "class=\"fa\" fill=\"" + look::hex(look::kBodyA.light) + "\""
                  : "class=\"fb\" fill=\"" + look::hex(look::kBodyB.light) + "\" stroke=\"" +
                        look::hex(look::kFaint.light) + "\"";
  }

  void row(const Row& row, double top) {
    svg_.text({kLeft - 10, top + 14}, shortened(scene_.bodies[row.body].name, kLongestName),
              {.size = 12, .anchor = Anchor::end});
    for (const Bar& bar : row.bars) {
      const double begin = x(static_cast<double>(bar.begin));
      const double end = x(static_cast<double>(bar.end + 1));
      svg_.rect({begin, top + (kRow - kBar) / 2}, std::max(kThinnest, end - begin), kBar,
                fmt::format("{} data-contact=\"{}\"", color(bar.moving), bar.contact));
    }
  }

  const Scene& scene_;
  double bottom_;
  reproduce::Axis axis_;
  Svg svg_;
};

}  // namespace

std::string time_line(const Scene& scene, std::size_t most_rows) {
  const std::vector<Row> rows = rows_of(scene, most_rows);
  if (scene.steps.count < 2 || rows.empty()) {
    return "";
  }
  return Drawing(scene, rows.size()).draw(rows);
}

}  // namespace soms::report
