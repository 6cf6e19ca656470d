#include "soms/io/rows.h"

#include "soms/base/arithmetic.h"
#include "soms/io/detail/numbers/csv_cells.h"
#include "soms/io/detail/numbers/line_reader.h"
#include "soms/io/detail/numbers/npy_rows.h"
#include "soms/io/detail/numbers/npz_array.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace soms {

namespace {

auto named(std::string_view name) {
  return [name](const Column& column) { return column.name == name; };
}

}  // namespace

struct RowReader::State {
  State(const std::filesystem::path& path, std::string_view what_rows_are,
        std::vector<std::vector<Column>> known, const Limits& given)
      : limits{.stop = given.stop},
        lines(path, limits),
        what(what_rows_are),
        headers(std::move(known)) {}

  Limits limits;
  detail::LineReader lines;
  std::string what;
  std::vector<std::vector<Column>> headers;
  std::vector<Column> columns;  ///< of the file, in the order of its header in `headers`
  std::vector<std::string_view> cells;
  std::vector<std::size_t> places;  ///< of the file's columns, in the header
  std::vector<double> numbers;
  std::optional<std::string_view> ahead;  ///< a row that `ready` found
  char separator = ',';
  std::optional<detail::NpzArray> archive;  ///< of a file that holds an array
  std::optional<detail::NpyRows> array;     ///< of a file that is not text

  [[nodiscard]] std::string here(const std::string& fault) const {
    return lines.name() + ", line " + std::to_string(lines.number()) + ": " + fault;
  }

  std::optional<std::string_view> next_line();
  void read_header();
  [[nodiscard]] std::string remedy() const;
  [[nodiscard]] std::string unknown_column() const;
  bool take(const std::vector<Column>& wanted);
};

/// The next line that is not blank and no comment.
std::optional<std::string_view> RowReader::State::next_line() {
  if (ahead) {
    return std::exchange(ahead, std::nullopt);
  }
  while (const auto line = lines.next()) {
    if (const auto text = detail::row_in(*line)) {
      return text;
    }
    check(limits);  // comments may have no end
  }
  return std::nullopt;
}

/// Takes the cells for a header if they name each of `wanted` once and nothing else, in any order.
bool RowReader::State::take(const std::vector<Column>& wanted) {
  places.clear();
  for (const std::string_view cell : cells) {
    const auto found = std::find_if(wanted.begin(), wanted.end(), named(cell));
    const auto place = static_cast<std::size_t>(found - wanted.begin());
    if (found == wanted.end() || std::find(places.begin(), places.end(), place) != places.end()) {
      return false;
    }
    places.push_back(place);
  }
  numbers.assign(wanted.size(), 0.0);
  return places.size() == wanted.size();
}

/// The first column that no header has, such as a time.
std::string RowReader::State::unknown_column() const {
  const auto is_known = [this](std::string_view cell) {
    return std::any_of(headers.begin(), headers.end(), [cell](const auto& header) {
      return std::any_of(header.begin(), header.end(), named(cell));
    });
  };
  const auto found = std::find_if_not(cells.begin(), cells.end(), is_known);
  const bool others = std::any_of(cells.begin(), cells.end(), is_known);
  return found == cells.end() || !others ? std::string() : detail::in_quotes(*found);
}

std::string RowReader::State::remedy() const {
  std::string text;
  for (const std::vector<Column>& header : headers) {
    text += text.empty() ? "begin with " : " or ";
    for (const Column& column : header) {
      text += column.name;
      text += &column == &header.back() ? "" : ",";
    }
  }
  return text;
}

void RowReader::State::read_header() {
  const auto line = next_line();
  if (!line) {
    throw Error(ErrorKind::bad_file, lines.name() + ": no header and no " + what, remedy());
  }
  separator = detail::separator_of(*line);
  detail::split_cells(*line, cells, separator);
  const auto found =
      std::find_if(headers.begin(), headers.end(), [this](const auto& h) { return take(h); });
  if (found == headers.end()) {
    const std::string column = unknown_column();
    throw Error(ErrorKind::bad_file,
                here("the header " + detail::in_quotes(*line) + " is not known"),
                column.empty() ? remedy() : "remove the column " + column + ", or " + remedy());
  }
  columns = *found;
}

RowReader::RowReader(const std::filesystem::path& path, std::string_view what,
                     std::vector<std::vector<Column>> headers, const Limits& limits)
    : state_(std::make_unique<State>(path, what, std::move(headers), limits)) {
  State& state = *state_;
  if (state.lines.starts_with(detail::kNpyMagic)) {
    state.array.emplace(state.lines, what, state.headers);
  } else if (state.lines.starts_with(detail::kZipMagic)) {
    state.archive.emplace(state.lines, what);
    state.array.emplace(state.archive->file(), what, state.headers);
  } else {
    state.read_header();
  }
}

RowReader::~RowReader() = default;
RowReader::RowReader(RowReader&&) noexcept = default;
RowReader& RowReader::operator=(RowReader&&) noexcept = default;

const std::vector<Column>& RowReader::columns() const {
  return state_->array ? state_->array->columns() : state_->columns;
}

std::optional<std::span<const double>> RowReader::next() {
  const PlainArithmetic plain;
  State& state = *state_;
  if (state.array) {
    return state.array->next();
  }
  const auto line = state.next_line();
  if (!line) {
    return std::nullopt;
  }
  detail::split_cells(*line, state.cells, state.separator);
  const std::size_t width = state.numbers.size();
  if (state.cells.size() != width) {
    throw Error(ErrorKind::bad_file,
                state.here(std::to_string(state.cells.size()) +
                           (state.cells.size() == 1 ? " number" : " numbers") +
                           ", but the header has " + std::to_string(width)),
                "give one number per column");
  }
  try {
    for (std::size_t i = 0; i < width; ++i) {
      const Column& column = state.columns[state.places[i]];
      state.numbers[state.places[i]] = detail::cell_number(
          state.cells[i], column.name, ErrorKind::bad_file, column.may_be_infinite);
    }
  } catch (const Error& error) {
    throw fault(error);
  }
  return state.numbers;
}

bool RowReader::ready() {
  State& state = *state_;
  try {
    if (state.array) {
      return state.array->ready();
    }
    while (!state.ahead) {
      if (!state.lines.ready()) {
        return false;
      }
      const auto line = state.lines.next();
      if (!line) {
        break;
      }
      state.ahead = detail::row_in(*line);
      check(state.limits);
    }
  } catch (const Error&) {  // `next` meets it again
  }
  return true;
}

Error RowReader::fault(const Error& error) const {
  const std::string place =
      state_->array ? state_->array->here(error.place()) : state_->here(error.place());
  return Error(error.kind(), place, error.remedy());
}

}  // namespace soms
