/// \file
/// The one door to GLFW, which shall not bring headers of OpenGL.
#pragma once

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
