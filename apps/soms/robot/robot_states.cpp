#include "apps/soms/robot/robot_states.h"

#include "soms/base/pose.h"
#include "soms/base/text.h"

#include "apps/cli/console.h"
#include "apps/cli/standard_input.h"
#include "apps/soms/robot/robot_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace soms::command {

namespace {

std::string state_names(const Robot& robot) {
  std::set<std::string> names;
  for (const NamedState& state : robot.states) {
    names.insert(state.name);
  }
  std::string text = "zero";
  for (const std::string& name : names) {
    text += ", " + name;
  }
  return text;
}

/// Throws where a value of a named state may be meant for another joint than the one it names:
/// for one of `missing`, which have no column.
void refuse_misnamed(const Robot& robot, const std::string& home,
                     const std::vector<std::uint32_t>& missing) {
  for (const NamedState& state : robot.states) {
    if (state.name != home || state.unknown.empty()) {
      continue;
    }
    for (const std::uint32_t joint : missing) {
      const bool is_set = std::any_of(state.values.begin(), state.values.end(),
                                      [&](const auto& value) { return value.first == joint; });
      if (!is_set) {
        throw Error(
            ErrorKind::usage,
            fmt::format("--home {}: the state has a value of \"{}\", a joint that the robot "
                        "does not have, and none of \"{}\"",
                        home, state.unknown.front(), robot.joints[joint].name),
            "repair the SRDF file, or give the joint a column");
      }
    }
  }
}

}  // namespace

std::optional<std::vector<double>> home_values(const RobotModels& models, const std::string& home) {
  if (home.empty()) {
    return std::nullopt;
  }
  const std::vector<std::uint32_t>& movable = models.model.kinematics().movable();
  std::vector<double> values(movable.size(), 0.0);
  bool found = home == "zero";
  for (const NamedState& state : models.robot.states) {
    if (state.name != home) {
      continue;
    }
    found = true;
    for (const auto& [joint, value] : state.values) {
      const auto place = std::find(movable.begin(), movable.end(), joint);
      if (place != movable.end()) {
        values[static_cast<std::size_t>(place - movable.begin())] = value;
      }
    }
  }
  if (!found) {
    throw Error(ErrorKind::usage, "--home: " + home + " is no state of the robot",
                "give one of " + state_names(models.robot));
  }
  return values;
}

RobotStates::RobotStates(const RobotVerbOptions& options, const RobotModels& models,
                         const Console& console)
    : models_(models),
      console_(console),
      name_(options.states == "-"    ? std::string(kStandardInputName)
            : options.states.empty() ? "random states"
                                     : options.states),
      rng_(options.seed),
      left_(options.random),
      strict_(options.reading.strict) {
  if (!options.states.empty()) {
    open(options.states, home_values(models, options.home));
    refuse_misnamed(models.robot, options.home, reader_->missing());
  }
}

void RobotStates::open(const std::string& path, std::optional<std::vector<double>> home) {
  if (path == "-") {
    check_standard_input("states");
  }
  try {
    reader_.emplace(path == "-" ? std::string(kStandardInput) : path, models_.model.kinematics(),
                    std::move(home), console_.limited());
  } catch (const Error& error) {
    fail(error);
  }
  if (!reader_->missing().empty()) {
    std::string names;
    for (const std::uint32_t joint : reader_->missing()) {
      names += (names.empty() ? "" : ", ") + models_.robot.joints[joint].name;
    }
    console_.note(printable(name_ + ": joints without a column, as --home has them: " + names));
  }
}

void RobotStates::fail(const Error& error) const {
  if (error.kind() == ErrorKind::cancelled && !console_.interrupted()) {
    throw Error(ErrorKind::timed_out, "out of time while reading states from " + name_,
                "allow more time with --timeout");
  }
  const std::string missing = "say which value such joints have";
  std::string remedy = error.remedy();
  if (const std::size_t at = remedy.find(missing); at != std::string::npos) {
    remedy.replace(at, missing.size(), missing + " by --home zero");
  }
  const Error in_words(error.kind(), error.place(), remedy);
  throw name_ == kStandardInputName ? of_standard_input(in_words) : in_words;
}

std::optional<std::span<const double>> RobotStates::read() {
  if (!reader_) {
    if (left_ == 0) {
      return std::nullopt;
    }
    --left_;
    state_ = random_state(models_.model.kinematics(), rng_);
    return state_;
  }
  try {
    const auto row = reader_->next();
    if (!row && rows_ == 0) {
      console_.note(printable(name_) + ": no rows");
    }
    return row;
  } catch (const Error& error) {
    fail(error);
  }
}

/// Whatever a query would refuse, named by its row, which a query of many does not know.
void RobotStates::check_state(std::span<const double> state) {
  const RobotModel& model = models_.model;
  const auto refuse = [&](const Error& error, const std::string& what) {
    throw Error(error.kind(), fmt::format("{}: state {}: {}{}", name_, rows_, what, error.place()),
                error.remedy());
  };
  std::vector<Pose> poses;
  try {
    poses = model.kinematics().link_poses(state, model.base());
  } catch (const Error& error) {
    refuse(error, "");
  }
  box_ = {};
  for (const RobotBody& body : model.link_bodies()) {
    const Pose& pose = poses[body.owner];
    const Box& box = body.part.body.shape.bounds();
    try {
      check(pose);
      check_range(pose, box);
    } catch (const Error& error) {
      refuse(error, "link " + model.link_names()[body.owner] + ": ");
    }
    for (unsigned corner = 0; corner < 8 && !box.empty(); ++corner) {
      box_.grow(pose.apply({(corner & 1U) != 0 ? box.upper.x : box.lower.x,
                            (corner & 2U) != 0 ? box.upper.y : box.lower.y,
                            (corner & 4U) != 0 ? box.upper.z : box.lower.z}));
    }
  }
  const std::vector<std::uint32_t> beyond = model.kinematics().beyond_limits(state);
  if (strict_ && !beyond.empty()) {
    throw Error(ErrorKind::bad_file,
                fmt::format("{}: state {}: {}", name_, rows_,
                            limit_in_words(models_, beyond.front(), state)),
                "give values inside the limits, or leave out --strict");
  }
}

std::optional<std::span<const double>> RobotStates::next() {
  const auto row = read();
  if (row) {
    check_state(*row);
    ++rows_;
  }
  return row;
}

}  // namespace soms::command
