/// \file
/// What the window does while its subject is made.
#pragma once

#include "apps/view/control/input_event.h"
#include "apps/view/window/app_window.h"

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace soms::view {

/// Instead of a share, where none is known.
inline constexpr double kNoShare = -1;

/// Says what is done now, and the share of it that is done. \errors ErrorKind::cancelled once the
/// work is not wanted any more.
using Say = std::function<void(const std::string& doing, double share)>;

/// Runs `work` in a thread of its own, and shows in the window what it says; calls `meanwhile`
/// after the first picture. Keeps what the user does in `events`. Returns false where the window
/// was closed, by Esc too, or a stop was requested; waits for the end of the work in any case.
/// \errors Those of `work`, and of `meanwhile`.
[[nodiscard]] bool work_behind(AppWindow& window, const std::function<void(const Say&)>& work,
                               const std::function<void()>& meanwhile,
                               std::vector<InputEvent>& events, const std::stop_token& stop);

}  // namespace soms::view
