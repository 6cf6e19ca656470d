/// \file
/// What happens when the display goes away under an open window.
#pragma once

namespace soms::view {

/// From now on the loss of the connection to an X server ends the program with one sentence on
/// standard error and exit status 5. Xlib cannot go on after it, and would else end the program
/// with words of its own. Does nothing where no Xlib is in use.
void end_when_the_display_is_lost();

}  // namespace soms::view
