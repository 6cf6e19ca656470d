#include "soms/io/poses.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/io/detail/line_reader.h"
#include "soms/io/detail/source.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace soms {

namespace {

constexpr std::array<std::string_view, 7> kShiftAndTurn = {"x", "y", "z", "qw", "qx", "qy", "qz"};
constexpr std::array<std::string_view, 12> kMatrix = {"r00", "r01", "r02", "tx",  "r10", "r11",
                                                      "r12", "ty",  "r20", "r21", "r22", "tz"};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && detail::is_blank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && detail::is_blank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

/// Cells of a line, without blanks around them.
void split(std::string_view line, std::vector<std::string_view>& cells) {
  cells.clear();
  while (true) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) {
      return;
    }
    line.remove_prefix(comma + 1);
  }
}

/// A number that fills its cell. \errors `bad`, ErrorKind::not_finite.
double number(std::string_view cell, std::string_view name, ErrorKind bad) {
  const char* end = cell.data() + cell.size();
  const detail::ParsedNumber parsed =
      detail::parse_number(cell.data(), end, detail::Precision::as_double);
  if (parsed.status == detail::NumberStatus::not_a_number || parsed.end != end) {
    throw Error(bad, std::string(name) + " is " + detail::in_quotes(cell) + ", not a number",
                "give a number such as 1.5 or -2e3");
  }
  if (parsed.status == detail::NumberStatus::too_large || !std::isfinite(parsed.value)) {
    throw Error(ErrorKind::not_finite,
                std::string(name) + " is " + detail::in_quotes(cell) + ", not a finite number",
                "give a finite number");
  }
  return parsed.value;
}

/// A pose from 3 numbers (a shift), 7 (a shift and a quaternion) or 12 (a matrix), checked.
Pose make_pose(std::span<const double> v) {
  Pose pose;
  if (v.size() == 3) {
    pose = Pose::translation(v[0], v[1], v[2]);
  } else if (v.size() == 7) {
    pose = Pose::from_quaternion(v[3], v[4], v[5], v[6], {v[0], v[1], v[2]});
  } else {
    std::copy(v.begin(), v.end(), pose.m.begin());
  }
  check(pose);
  return pose;
}

}  // namespace

Pose parse_pose(std::string_view text) {
  const PlainArithmetic plain;
  std::vector<double> numbers;
  const std::string quoted = "pose " + detail::in_quotes(text);
  const std::string remedy = "give \"x y z\" or \"x y z qw qx qy qz\"";
  bool after_comma = true;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == ',' && after_comma) {
      throw Error(ErrorKind::usage, quoted + " has a comma without a number before it", remedy);
    }
    if (text[at] == ',' || detail::is_blank(text[at])) {
      after_comma = after_comma || text[at] == ',';
      ++at;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(", \t\v\f", at), text.size());
    if (numbers.size() == kShiftAndTurn.size()) {
      throw Error(ErrorKind::usage, quoted + " has more than 7 numbers", remedy);
    }
    numbers.push_back(number(text.substr(at, end - at),
                             "pose: " + std::string(kShiftAndTurn[numbers.size()]),
                             ErrorKind::usage));
    after_comma = false;
    at = end;
  }
  if ((numbers.size() != 3 && numbers.size() != 7) || after_comma) {
    throw Error(ErrorKind::usage, quoted + " has " + std::to_string(numbers.size()) + " numbers",
                remedy);
  }
  return make_pose(numbers);
}

struct PoseReader::State {
  State(const std::filesystem::path& path, const Parallel& given)
      : parallel{.stop = given.stop}, lines(path, parallel) {}

  Parallel parallel;
  detail::LineReader lines;
  std::vector<std::string_view> cells;
  std::vector<std::string_view> names;  ///< of the columns, in the file's order
  std::vector<std::size_t> places;      ///< where a column's number goes
  std::vector<double> numbers;
  std::optional<std::string_view> ahead;  ///< a row that `ready` found

  /// The next line that is not blank and no comment.
  std::optional<std::string_view> next_line() {
    if (ahead) {
      return std::exchange(ahead, std::nullopt);
    }
    while (const auto line = lines.next()) {
      if (const auto text = row_in(*line)) {
        return text;
      }
      check_stop(parallel);  // comments may have no end
    }
    return std::nullopt;
  }

  /// What a line holds, but of blanks and comments nothing.
  static std::optional<std::string_view> row_in(std::string_view line) {
    const std::string_view text = trimmed(line);
    return text.empty() || text[0] == '#' ? std::nullopt : std::optional(text);
  }

  [[noreturn]] void fail(ErrorKind kind, const std::string& what, const std::string& remedy) const {
    throw Error(kind, lines.name() + ", line " + std::to_string(lines.number()) + ": " + what,
                remedy);
  }

  void read_header();
  [[nodiscard]] std::string unknown_column() const;
  bool take_columns(std::span<const std::string_view> wanted);
};

/// Takes the columns if the header names each of `wanted` once and nothing else, in any order.
bool PoseReader::State::take_columns(std::span<const std::string_view> wanted) {
  names.clear();
  places.clear();
  for (const std::string_view cell : cells) {
    const auto found = std::find(wanted.begin(), wanted.end(), cell);
    if (found == wanted.end() || std::find(names.begin(), names.end(), *found) != names.end()) {
      return false;
    }
    names.push_back(*found);
    places.push_back(static_cast<std::size_t>(found - wanted.begin()));
  }
  numbers.assign(wanted.size(), 0.0);
  return names.size() == wanted.size();
}

/// The first column that no header has, such as a time.
std::string PoseReader::State::unknown_column() const {
  const auto is_known = [](std::string_view cell) {
    return std::find(kShiftAndTurn.begin(), kShiftAndTurn.end(), cell) != kShiftAndTurn.end() ||
           std::find(kMatrix.begin(), kMatrix.end(), cell) != kMatrix.end();
  };
  const auto found = std::find_if_not(cells.begin(), cells.end(), is_known);
  const bool others = std::any_of(cells.begin(), cells.end(), is_known);
  return found == cells.end() || !others ? std::string() : detail::in_quotes(*found);
}

void PoseReader::State::read_header() {
  const std::string remedy =
      "begin with x,y,z or x,y,z,qw,qx,qy,qz or r00,r01,r02,tx,r10,r11,r12,ty,r20,r21,r22,tz";
  const auto line = next_line();
  if (!line) {
    throw Error(ErrorKind::bad_file, lines.name() + ": no header and no poses", remedy);
  }
  split(*line, cells);
  if (!take_columns(std::span(kShiftAndTurn).first(3)) && !take_columns(kShiftAndTurn) &&
      !take_columns(kMatrix)) {
    const std::string column = unknown_column();
    fail(ErrorKind::bad_file, "the header " + detail::in_quotes(*line) + " is not known",
         column.empty() ? remedy : "remove the column " + column + ", or " + remedy);
  }
}

PoseReader::PoseReader(const std::filesystem::path& path, const Parallel& parallel)
    : state_(std::make_unique<State>(path, parallel)) {
  state_->read_header();
}

PoseReader::~PoseReader() = default;
PoseReader::PoseReader(PoseReader&&) noexcept = default;
PoseReader& PoseReader::operator=(PoseReader&&) noexcept = default;

std::optional<Pose> PoseReader::next() {
  const PlainArithmetic plain;
  State& state = *state_;
  const auto line = state.next_line();
  if (!line) {
    return std::nullopt;
  }
  split(*line, state.cells);
  if (state.cells.size() != state.names.size()) {
    state.fail(ErrorKind::bad_file,
               std::to_string(state.cells.size()) +
                   (state.cells.size() == 1 ? " number" : " numbers") + ", but the header has " +
                   std::to_string(state.names.size()),
               "give one number per column");
  }
  try {
    for (std::size_t i = 0; i < state.cells.size(); ++i) {
      state.numbers[state.places[i]] = number(state.cells[i], state.names[i], ErrorKind::bad_file);
    }
    return make_pose(state.numbers);
  } catch (const Error& error) {
    state.fail(error.kind(), error.place(), error.remedy());
  }
}

bool PoseReader::ready() {
  State& state = *state_;
  try {
    while (!state.ahead) {
      if (!state.lines.ready()) {
        return false;
      }
      const auto line = state.lines.next();
      if (!line) {
        break;
      }
      state.ahead = State::row_in(*line);
      check_stop(state.parallel);
    }
  } catch (const Error&) {  // `next` meets it again
  }
  return true;
}

bool PoseReader::shifts_only() const {
  return state_->names.size() == 3;
}

std::vector<Pose> read_poses(const std::filesystem::path& path, const Parallel& parallel) {
  PoseReader reader(path, parallel);
  std::vector<Pose> poses;
  while (const auto pose = reader.next()) {
    poses.push_back(*pose);
  }
  return poses;
}

}  // namespace soms
