/// \file
/// The first contact of a body that follows a law with another: the answer for one motion.
#pragma once

#include "soms/base/limits.h"
#include "soms/motion/detail/motion_law.h"
#include "soms/motion/first_contact.h"
#include "soms/query/detail/engine/node_id.h"

#include <array>
#include <cstdint>
#include <span>

namespace soms::detail {

/// What is known of the bodies at 0 and at 1.
enum class EndsOfWay {
  unknown,
  free,  ///< their surfaces do not meet, by the decision for the poses of the law
};

/// All of a body.
inline constexpr std::array<std::uint32_t, 1> kWholeBody = {kRootId};

/// What a caller knows of a way.
struct KnownOfWay {
  EndsOfWay ends = EndsOfWay::unknown;
  /// Ids of nodes and leaves of the other body: below them is all of it that may touch the mover
  /// on the way. With fewer of them, the last bits of a bracket may be others.
  std::span<const std::uint32_t> nodes = kWholeBody;
};

/// \pre The poses passed their checks, and `options` too; no mesh is empty.
/// \errors As `first_contact`.
[[nodiscard]] FirstContact first_contact_by(const MotionLaw& law, const Shape& mover,
                                            const Shape& other, const FirstContactOptions& options,
                                            const Limits& limits, const KnownOfWay& known = {});

}  // namespace soms::detail
