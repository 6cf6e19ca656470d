/// \file
/// The bodies of a scene, with their world boxes and whom they ignore.
#pragma once

#include "soms/base/box.h"
#include "soms/query/body.h"
#include "soms/scene/detail/id_list.h"
#include "soms/scene/detail/last_place.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace soms::detail {

/// A body of the scene with its world box, which is set together with pose and shape and nowhere
/// else.
struct Resident {
  Body body;
  Box box;
  std::uint32_t group = 0;
  /// Mover: numbers of movers not compared with. Kept on both sides, so removal finds all.
  std::vector<std::uint32_t> ignored_movers;
  /// Mover: parts not compared with. Part: the movers that ignore it.
  std::vector<std::uint32_t> ignored_others;
  /// Mover: where it was at the last step.
  LastPlace last = {};
};

using Residents = IdList<Resident>;

/// Bytes held, shapes and names not counted.
[[nodiscard]] std::size_t memory_of(const Residents& residents);

/// The world boxes, by place, instead of what `boxes` held.
void collect_boxes(const Residents& residents, std::vector<Box>& boxes);

/// World box of a body with a shape at a pose. \errors As `overlap` for the pose; the message names
/// the body.
[[nodiscard]] Box world_box(const Body& body, const Shape& shape, const Pose& pose,
                            std::string_view what, std::optional<std::uint32_t> id = std::nullopt);

/// Lists of ignored bodies are sorted.
[[nodiscard]] bool holds(const std::vector<std::uint32_t>& sorted, std::uint32_t id);

/// Each into the other's list: into both or, where memory runs short, into none. \returns false if
/// they were there before.
bool insert_mutually(std::vector<std::uint32_t>& list_a, std::uint32_t b,
                     std::vector<std::uint32_t>& list_b, std::uint32_t a);

/// Without effect where `id` is not there. \returns whether it was.
bool erase(std::vector<std::uint32_t>& sorted, std::uint32_t id);

}  // namespace soms::detail
