#include "thesis/page/listing.h"

#include "apps/draw/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr double kListingWidth = 1000;
/// Up to here the page grows to keep steps beside the code.
constexpr double kWidest = 1100;
constexpr double kMargin = 20;
constexpr double kListingTop = 104;
constexpr double kCodeLeft = 64;
constexpr double kIndent = 26;
constexpr double kCodeLine = 27;
constexpr double kCodeSize = 16;
constexpr double kExampleSize = 14;
constexpr double kStepLine = 21;
constexpr double kStepSize = 13;
constexpr double kBesideCode = 44;
constexpr double kBetweenColumns = 16;

/// A number as in the CSV, where the page's three digits would hide what a step changed.
std::string cell_words(const Cell& cell) {
  if (const double* const number = std::get_if<double>(&cell)) {
    return fmt::format("{:.6g}", *number);
  }
  return to_text(cell);
}

bool is_number(const Cell& cell) {
  return std::holds_alternative<double>(cell) || std::holds_alternative<std::int64_t>(cell);
}

/// A column of steps as it is drawn.
struct StepColumn {
  std::string name;
  std::vector<std::string> cells = {};
  bool numbers = true;  ///< nothing but numbers: they end where the column ends
  double width = 0;
};

std::vector<StepColumn> step_columns(const Table& table) {
  std::vector<StepColumn> columns;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    StepColumn column{table.columns[k].name};
    std::replace(column.name.begin(), column.name.end(), '_', ' ');
    column.width = text_width(column.name, kStepSize);
    for (const std::vector<Cell>& row : table.rows) {
      column.cells.push_back(cell_words(row[k]));
      column.width = std::max(column.width, text_width(column.cells.back(), kStepSize));
      column.numbers =
          column.numbers && (is_number(row[k]) || std::holds_alternative<std::monostate>(row[k]));
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

double width_of(const std::vector<StepColumn>& columns) {
  double width = columns.empty() ? 0 : -kBetweenColumns;
  for (const StepColumn& column : columns) {
    width += column.width + kBetweenColumns;
  }
  return width;
}

/// Places a listing on its page.
class ListingPage {
 public:
  explicit ListingPage(const Listing& listing)
      : listing_(listing),
        columns_(listing.steps == nullptr ? std::vector<StepColumn>()
                                          : step_columns(*listing.steps)),
        code_height_(kCodeLine * static_cast<double>(listing.lines.size())),
        right_of_code_(code_right() + kBesideCode) {
    steps_width_ = std::max(width_of(columns_), text_width(listing.heading, kStepSize));
    beside_ = listing.steps == nullptr || right_of_code_ + steps_width_ + kMargin <= kWidest;
    left_ = beside_ ? right_of_code_ : kCodeLeft;
    top_ = beside_ ? kListingTop : kListingTop + code_height_ + 44;
  }

  [[nodiscard]] std::string draw() const {
    const double width =
        std::max({kListingWidth, left_ + steps_width_ + kMargin, examples_right()});
    Svg svg(width, height(), listing_.title);
    svg.text({kMargin, 30}, listing_.title, {.size = 17, .bold = true});
    draw_code(svg);
    if (listing_.steps != nullptr) {
      draw_steps(svg);
    }
    return svg.document();
  }

 private:
  [[nodiscard]] double code_right() const {
    double right = 0;
    for (const CodeLine& line : listing_.lines) {
      right = std::max(right, code_left(line) + text_width(line.code, kCodeSize, line.indent == 0));
    }
    return right;
  }

  [[nodiscard]] double examples_right() const {
    double right = 0;
    for (const CodeLine& line : listing_.lines) {
      right = std::max(right, right_of_code_ + text_width(line.example, kExampleSize) + kMargin);
    }
    return right;
  }

  [[nodiscard]] static double code_left(const CodeLine& line) {
    return kCodeLeft + kIndent * line.indent;
  }

  [[nodiscard]] double steps_height() const {
    return columns_.empty() ? 0 : kStepLine * static_cast<double>(listing_.steps->rows.size() + 1);
  }

  [[nodiscard]] double height() const {
    return std::max(kListingTop + code_height_ + 6, top_ + steps_height() + 6);
  }

  void draw_code(Svg& svg) const {
    svg.text({kMargin, kListingTop - 32}, "line", {.size = 13, .faint = true});
    if (beside_) {
      svg.text({left_, kListingTop - 32}, listing_.heading, {.size = 13, .faint = true});
      svg.line({left_ - 18, kListingTop - 46}, {left_ - 18, height() - 16},
               "class=\"axis\" stroke=\"#8a8d91\"");
    }
    double y = kListingTop;
    for (std::size_t k = 0; k < listing_.lines.size(); ++k, y += kCodeLine) {
      const CodeLine& line = listing_.lines[k];
      svg.text({44, y}, fmt::format("{}", k + 1),
               {.size = 13, .anchor = Anchor::end, .faint = true});
      svg.text({code_left(line), y}, line.code, {.size = kCodeSize, .bold = line.indent == 0});
      if (!line.example.empty()) {
        svg.text({left_, y}, line.example, {.size = kExampleSize});
      }
    }
  }

  void draw_steps(Svg& svg) const {
    double y = top_;
    if (!beside_) {
      svg.text({kMargin, y - 24}, listing_.heading, {.size = 13, .faint = true});
    }
    const auto put = [&](const StepColumn& column, double x, const std::string& words, bool head) {
      svg.text({column.numbers ? x + column.width : x, y}, words,
               {.size = kStepSize,
                .anchor = column.numbers ? Anchor::end : Anchor::start,
                .faint = head});
    };
    for (std::size_t row = 0; row <= listing_.steps->rows.size(); ++row, y += kStepLine) {
      double x = left_;
      for (const StepColumn& column : columns_) {
        put(column, x, row == 0 ? column.name : column.cells[row - 1], row == 0);
        x += column.width + kBetweenColumns;
      }
    }
  }

  const Listing& listing_;
  std::vector<StepColumn> columns_;
  double code_height_;
  double right_of_code_;
  double steps_width_ = 0;
  bool beside_ = true;  ///< what a run made of it stands at the right of the code
  double left_ = 0;     ///< of what a run made of it
  double top_ = 0;
};

}  // namespace

std::string draw_listing(const Listing& listing) {
  return ListingPage(listing).draw();
}

Figure listing_figure(std::string id, std::string caption, const Listing& listing) {
  std::string alt;
  for (std::size_t k = 0; k < listing.lines.size(); ++k) {
    alt += fmt::format("{}: {} ", k + 1, listing.lines[k].code);
  }
  return {.id = std::move(id),
          .caption = std::move(caption),
          .svg = draw_listing(listing),
          .alt = std::move(alt)};
}

Result listing_result(const std::string& id, std::string caption, Listing listing, Table steps) {
  listing.steps = &steps;
  caption += kFromCaption;
  Result result;
  result.figures = {listing_figure(id, std::move(caption), listing)};
  result.tables = {std::move(steps)};
  return result;
}

}  // namespace soms::reproduce
