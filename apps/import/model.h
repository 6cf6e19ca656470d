/// \file
/// A model as soms takes it from a child: vertices, faces, parts and notes, one after the other.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

struct aiScene;

namespace soms::import_program {

/// Writes records to standard output. The form stands in docs/formats.md.
class Answer {
 public:
  Answer();

  void vertex(double x, double y, double z);
  void face(std::span<const std::uint32_t> corners);
  void begin_part(std::string_view name);
  void end_part();
  void note(std::string_view words);
  /// Meters a unit.
  void unit(double meters);
  /// The axis that is up: 'x', 'y' or 'z'.
  void up(char axis);
  /// The last record. False if anything could not be written.
  [[nodiscard]] bool finish();

 private:
  void number(std::uint32_t value);
  void coordinate(double value);
  void text(char kind, std::string_view words);
  void flush();

  std::string bytes_;
  bool whole_ = true;
};

/// Writes what the scene's nodes show, each mesh under the transforms of its node, and what is
/// known of axes and unit. Assimp's own turn of the axes, by its root node, is undone. `extension`
/// is the file's.
void write_scene(const aiScene& scene, std::string_view extension, Answer& answer);

}  // namespace soms::import_program
