/// \file
/// Models of robots as objects of Python, and answers of many states.
#pragma once

#include "soms/robot/robot_query.h"

#include "python/src/answer.h"
#include "python/src/objects.h"
#include "python/src/packing.h"
#include "python/src/part_set.h"
#include "python/src/scene/robots.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace soms::python {

/// A model with what its numbers name.
struct HeldRobotModel {
  SharedRobot robot;
  RobotModel model;
  std::vector<std::string> cell_names;
  std::vector<PosedMesh> cell;  ///< what it was made of, beside the robot
  RobotModelOptions options;
};

using SharedModel = std::shared_ptr<HeldRobotModel>;

/// Answers of n states.
struct RobotAnswerBatch {
  std::vector<RobotAnswer> answers;
  std::vector<RobotContact> contacts;
  std::vector<std::uint64_t> offsets;
  Cost cost;

  explicit RobotAnswerBatch(std::vector<RobotAnswer> given) : answers(std::move(given)) {
    offsets.push_back(0);
    for (const RobotAnswer& answer : answers) {
      contacts.insert(contacts.end(), answer.contacts.begin(), answer.contacts.end());
      offsets.push_back(contacts.size());
      cost += answer.cost;
    }
  }

  [[nodiscard]] std::size_t size() const { return answers.size(); }

  [[nodiscard]] RobotAnswer at(std::size_t state) const { return answers[state]; }

  [[nodiscard]] bool operator==(const RobotAnswerBatch& other) const {
    return answers == other.answers;
  }
};

std::ostream& operator<<(std::ostream& out, const RobotAnswerBatch& batch);

/// All else of a batch follows from its answers.
template <>
struct Packing<RobotAnswerBatch> {
  static void put(Packer& to, const RobotAnswerBatch& batch) { to.put(batch.answers); }

  static RobotAnswerBatch get(Unpacker& from) {
    return RobotAnswerBatch(from.get<std::vector<RobotAnswer>>());
  }
};

/// (link, other, cell), or None.
[[nodiscard]] py::object pair_of(const std::optional<RobotPair>& pair);

}  // namespace soms::python
