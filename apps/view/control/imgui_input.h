/// \file
/// The one door to Dear ImGui: sources that draw panels include this and nothing else of it.
#pragma once

// The package keeps its headers in a folder that its compile flags name; they are a system's, so
// our warnings do not look into them.
#include <imgui.h>
