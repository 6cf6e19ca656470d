/// \file
/// OpenGL without a screen.
#pragma once

#include <memory>

namespace soms::view {

/// An OpenGL 3.3 core context by EGL, without window or display server, by the first of the drivers
/// here that offers it; current in the thread that made it until it ends.
class HeadlessContext {
 public:
  /// \errors ErrorKind::cannot_write names what is missing: the EGL library, a driver that draws
  ///         without a screen, or OpenGL 3.3 (of the first driver, where none offers it).
  HeadlessContext();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace soms::view
