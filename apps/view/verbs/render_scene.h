/// \file
/// The scene of a picture, as named on the command line.
#pragma once

#include "apps/cli/console.h"
#include "apps/view/scene/scene_content.h"
#include "apps/world/world_options.h"

#include <string>

namespace soms::command {
class Parser;
}  // namespace soms::command

namespace soms::view {

/// Most poses of --pose that are drawn.
inline constexpr std::size_t kMostPoses = 100'000;

/// Reads what the options name. A recording in place of a city is played. A city from files has no
/// movers unless they are requested, and of models of --mover without a count or route one each,
/// where a simulation has a thousand in all. With `pose` the one model of --mover stands at each of
/// its poses instead of going its way. `guess_up` is ignored where a pose, a route or a count says
/// where movers are: then all is as in `simulate`. \errors As `command::load_world` and
/// `PoseSource`; ErrorKind::usage for poses with no mover or with several.
[[nodiscard]] SceneContent load_content(command::WorldOptions options, const std::string& pose,
                                        command::Console& console);

/// Makes the second of two models that were named alone a mover that stands where its file puts it,
/// so that their contacts are found. Tiles of a city stay one: flat, of many buildings, or with a
/// place on the Earth.
void make_pair_of_two(SceneContent& content);

/// Adds --test, which names an orientation test.
void add_test(command::Parser& parser, std::string& test, const std::string& text);

/// As `load_content` for an orientation test, which moves the one model of --mover. Models whose
/// files name no axis stand as they look, so that a test comes from the side that it names.
/// \errors As `load_content`; ErrorKind::usage unless there is one mover and no pose.
[[nodiscard]] SceneContent load_tested(command::WorldOptions options, const std::string& pose,
                                       command::Console& console);

/// Meters a unit of a scene: of the embedded city, a recording and a scale that was given it is
/// one; else what the city's first model declares. 0: not known.
[[nodiscard]] double meters_of_unit(const command::WorldOptions& options, bool is_recording,
                                    double declared);

}  // namespace soms::view
