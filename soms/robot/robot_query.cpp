#include "soms/robot/robot_query.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/robot/detail/state_query.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace soms {

namespace {

/// States that a thread takes at a time.
constexpr std::size_t kStatesOfAChunk = 16;

/// Without movable joints every state is the same empty row.
std::size_t rows_of(std::size_t numbers, std::size_t width) {
  if (width == 0 ? numbers != 0 : numbers % width != 0) {
    throw Error(
        ErrorKind::usage,
        std::to_string(numbers) + " numbers are not whole states of " + std::to_string(width),
        "give one number for each movable joint of each state");
  }
  return width == 0 ? 1 : numbers / width;
}

void check_options(const RobotOptions& options) {
  if (!(options.at_most >= 0)) {
    throw Error(ErrorKind::usage, "the greatest distance is not a number of at least 0",
                "give a distance, or infinity");
  }
  if (!options.distance && !std::isinf(options.at_most)) {
    throw Error(ErrorKind::usage, "a greatest distance has no effect where none is measured",
                "also set `distance`");
  }
}

}  // namespace

std::vector<RobotAnswer> robot_contacts(const RobotModel& model, std::span<const double> states,
                                        const RobotOptions& options, const Limits& limits) {
  check_options(options);
  const std::size_t width = model.kinematics().size();
  const std::size_t rows = rows_of(states.size(), width);
  std::vector<RobotAnswer> answers(rows);
  for_each_chunk(
      rows, kStatesOfAChunk, limits.without_deadline(), [&](std::size_t begin, std::size_t end) {
        const PlainArithmetic plain;
        detail::StateQuery query(model, options, limits);
        for (std::size_t k = begin; k < end; ++k) {
          try {
            answers[k] = query.answer(states.subspan(k * width, width));
          } catch (const Error& error) {
            if (error.kind() == ErrorKind::cancelled) {
              throw;
            }
            throw Error(error.kind(), "state " + std::to_string(k) + ": " + error.place(),
                        error.remedy());
          }
        }
      });
  return answers;
}

}  // namespace soms
