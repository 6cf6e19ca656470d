#include "soms/io/robot_states.h"

#include "soms/base/arithmetic.h"
#include "soms/io/detail/numbers/csv_cells.h"
#include "soms/io/detail/numbers/line_reader.h"
#include "soms/io/detail/numbers/npy_rows.h"
#include "soms/io/detail/numbers/npz_array.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace soms {

struct RobotStateReader::State {
  State(const std::filesystem::path& path, const Kinematics& kinematics_given, const Limits& given)
      : kinematics(kinematics_given), limits{.stop = given.stop}, lines(path, limits) {}

  const Kinematics& kinematics;
  Limits limits;
  detail::LineReader lines;
  std::vector<std::size_t> places;  ///< of the file's columns, in a state
  std::vector<std::uint32_t> missing;
  std::vector<std::string_view> cells;
  std::vector<double> values;
  std::vector<std::string> names;    ///< of movable joints
  std::optional<std::string> ahead;  ///< a row that `ready` found, or the first one
  char separator = ',';
  std::optional<detail::NpzArray> archive;  ///< of a file that holds an array
  std::optional<detail::NpyRows> array;     ///< of a file that is not text

  [[nodiscard]] Error bad(const std::string& fault, const std::string& remedy) const {
    return Error(ErrorKind::bad_file,
                 lines.name() + ", line " + std::to_string(lines.number()) + ": " + fault, remedy);
  }

  std::optional<std::string> next_line();
  void open_array(detail::LineReader& file);
  void read_first_row();
  void take_header();
  [[nodiscard]] std::size_t place_of(std::string_view name) const;
  [[nodiscard]] std::string all_names() const;
};

std::optional<std::string> RobotStateReader::State::next_line() {
  if (ahead) {
    return std::exchange(ahead, std::nullopt);
  }
  while (const auto line = lines.next()) {
    if (const auto text = detail::row_in(*line)) {
      return std::string(*text);
    }
    check(limits);  // comments may have no end
  }
  return std::nullopt;
}

std::string RobotStateReader::State::all_names() const {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ",") + name;
  }
  return text;
}

/// Place of a column's joint in a state.
std::size_t RobotStateReader::State::place_of(std::string_view name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) {
    return static_cast<std::size_t>(found - names.begin());
  }
  const std::vector<Joint>& joints = kinematics.joints();
  const auto joint = std::find_if(joints.begin(), joints.end(),
                                  [&](const Joint& other) { return other.name == name; });
  const std::string column = "the column " + detail::in_quotes(name);
  if (joint == joints.end()) {
    throw bad(column + " is no joint of the robot", "remove it; the joints are " + all_names());
  }
  throw bad(column + (joint->mimic ? " is a joint that follows " +
                                         detail::in_quotes(joints[joint->mimic->joint].name)
                                   : " is a fixed joint"),
            "remove it: it has no value of its own");
}

void RobotStateReader::State::take_header() {
  std::vector<std::uint8_t> has_column(names.size(), 0);
  for (const std::string_view cell : cells) {
    const std::size_t place = place_of(cell);
    if (has_column[place] != 0) {
      throw bad("the column " + detail::in_quotes(cell) + " occurs twice", "remove one of them");
    }
    has_column[place] = 1;
    places.push_back(place);
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (has_column[k] == 0) {
      missing.push_back(kinematics.movable()[k]);
    }
  }
}

/// A header, or the first state.
void RobotStateReader::State::read_first_row() {
  const auto line = next_line();
  if (!line) {
    throw Error(ErrorKind::bad_file, lines.name() + ": no states",
                "begin with " + all_names() + ", and a line for each state");
  }
  // A name may have a semicolon, too.
  const bool is_named = std::any_of(names.begin(), names.end(), [](const std::string& name) {
    return name.find(';') != std::string::npos;
  });
  separator = is_named ? ',' : detail::separator_of(*line);
  detail::split_cells(*line, cells, separator);
  // Joints may have numbers for names.
  const bool has_names = std::all_of(cells.begin(), cells.end(), [this](std::string_view cell) {
    return std::find(names.begin(), names.end(), cell) != names.end();
  });
  const bool is_header =
      has_names || std::any_of(cells.begin(), cells.end(), [](std::string_view cell) {
        const char* const end = cell.data() + cell.size();
        const detail::ParsedNumber parsed =
            detail::parse_number(cell.data(), end, detail::Precision::as_double);
        return parsed.status == detail::NumberStatus::not_a_number || parsed.end != end;
      });
  if (is_header) {
    take_header();
    return;
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    places.push_back(k);
  }
  ahead = *line;
}

void RobotStateReader::State::open_array(detail::LineReader& file) {
  std::vector<Column> columns;
  for (const std::string& name : names) {
    columns.push_back({.name = name});
  }
  const std::vector<std::vector<Column>> headers{std::move(columns)};
  array.emplace(file, "states", headers);
}

RobotStateReader::RobotStateReader(const std::filesystem::path& path, const Kinematics& kinematics,
                                   std::optional<std::vector<double>> home, const Limits& limits)
    : state_(std::make_unique<State>(path, kinematics, limits)) {
  State& state = *state_;
  for (const std::uint32_t joint : kinematics.movable()) {
    state.names.push_back(kinematics.joints()[joint].name);
  }
  if (home && home->size() != state.names.size()) {
    throw Error(ErrorKind::usage, "the home state has another number of values than joints",
                "give one for each movable joint");
  }
  state.values = home.value_or(std::vector<double>(state.names.size(), 0.0));
  if (state.lines.starts_with(detail::kNpyMagic)) {
    state.open_array(state.lines);
    return;
  }
  if (state.lines.starts_with(detail::kZipMagic)) {
    state.archive.emplace(state.lines, "states");
    state.open_array(state.archive->file());
    return;
  }
  state.read_first_row();
  if (!state.missing.empty() && !home) {
    throw state.bad("no column for the joint " +
                        detail::in_quotes(kinematics.joints()[state.missing.front()].name) +
                        (state.missing.size() == 1
                             ? std::string()
                             : " and " + std::to_string(state.missing.size() - 1) + " more"),
                    "add it, or say which value such joints have");
  }
}

RobotStateReader::~RobotStateReader() = default;
RobotStateReader::RobotStateReader(RobotStateReader&&) noexcept = default;
RobotStateReader& RobotStateReader::operator=(RobotStateReader&&) noexcept = default;

std::optional<std::span<const double>> RobotStateReader::next() {
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
  if (state.cells.size() != state.places.size()) {
    throw state.bad(std::to_string(state.cells.size()) +
                        (state.cells.size() == 1 ? " number for " : " numbers for ") +
                        std::to_string(state.places.size()) +
                        (state.places.size() == 1 ? " joint" : " joints"),
                    "give one number per joint: " + state.all_names());
  }
  for (std::size_t i = 0; i < state.cells.size(); ++i) {
    const std::size_t place = state.places[i];
    try {
      state.values[place] =
          detail::cell_number(state.cells[i], state.names[place], ErrorKind::bad_file);
    } catch (const Error& error) {
      throw Error(error.kind(), state.bad(error.place(), "").place(), error.remedy());
    }
  }
  return state.values;
}

bool RobotStateReader::ready() {
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
      if (const auto text = detail::row_in(*line)) {
        state.ahead = std::string(*text);
      }
      check(state.limits);
    }
  } catch (const Error&) {  // `next` meets it again
  }
  return true;
}

const std::vector<std::uint32_t>& RobotStateReader::missing() const {
  return state_->missing;
}

}  // namespace soms
