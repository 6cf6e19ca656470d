/// \file
/// Which movers are tested against each other.
#pragma once

#include "soms/scene/step_report.h"

#include <string>
#include <utility>
#include <vector>

namespace soms::command {

struct World;

/// Two movers as `--ignore-pair` names them: by number, or by the name of their model.
using NamedPair = std::pair<std::string, std::string>;

/// Movers that are not tested against each other.
struct MoverFilter {
  bool between = true;  ///< movers are tested against each other at all
  /// Pairs that are not; the lesser mover first, sorted, each once.
  std::vector<std::pair<MoverId, MoverId>> ignored = {};

  /// True if the two are tested, in either order.
  [[nodiscard]] bool tests(MoverId a, MoverId b) const;
};

/// "A,B". \errors ErrorKind::usage for another form.
[[nodiscard]] NamedPair parse_pair(const std::string& text);

/// The pairs of movers that the names stand for. A name stands for all movers of its model.
/// \errors ErrorKind::usage for a name or number of no mover, for names of only one mover, and for
///         more than a million pairs.
[[nodiscard]] std::vector<std::pair<MoverId, MoverId>> ignored_pairs(
    const World& world, const std::vector<NamedPair>& named);

}  // namespace soms::command
