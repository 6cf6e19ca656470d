/// \file
/// The one door to the back ends of Dear ImGui.
#pragma once

#include "apps/view/control/imgui_input.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
