#include "soms/io/poses.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace soms {

namespace {

constexpr std::array<std::string_view, 7> kShiftAndTurn = {"x", "y", "z", "qw", "qx", "qy", "qz"};
constexpr std::array<std::string_view, 12> kMatrix = {"r00", "r01", "r02", "tx",  "r10", "r11",
                                                      "r12", "ty",  "r20", "r21", "r22", "tz"};

std::vector<Column> columns(std::span<const std::string_view> names) {
  std::vector<Column> columns;
  for (const std::string_view name : names) {
    columns.push_back({name});
  }
  return columns;
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
    numbers.push_back(detail::cell_number(text.substr(at, end - at),
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

PoseReader::PoseReader(const std::filesystem::path& path, const Limits& limits)
    : rows_(path, "poses",
            {columns(std::span(kShiftAndTurn).first(3)), columns(kShiftAndTurn), columns(kMatrix)},
            limits) {
}

std::optional<Pose> PoseReader::next() {
  const PlainArithmetic plain;
  const auto row = rows_.next();
  if (!row) {
    return std::nullopt;
  }
  try {
    return make_pose(*row);
  } catch (const Error& error) {
    throw rows_.fault(error);
  }
}

std::vector<Pose> read_poses(const std::filesystem::path& path, const Limits& limits) {
  PoseReader reader(path, limits);
  std::vector<Pose> poses;
  while (const auto pose = reader.next()) {
    poses.push_back(*pose);
  }
  return poses;
}

}  // namespace soms
