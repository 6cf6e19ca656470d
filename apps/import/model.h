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
  void note(std::string_view text);
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

/// Writes what the scene's nodes show, each mesh under the transforms of its node.
void write_scene(const aiScene& scene, Answer& answer);

}  // namespace soms::import_program
