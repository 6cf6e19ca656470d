/// \file
/// Owners of what lives on the device: buffers, vertex arrays, programs. Private to the renderer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace soms::view {

/// A buffer of vertices, indices or rows of instances.
class GlBuffer {
 public:
  GlBuffer();
  ~GlBuffer();

  GlBuffer(GlBuffer&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

  GlBuffer& operator=(GlBuffer&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }

  [[nodiscard]] unsigned id() const { return id_; }

  /// Replaces the content by one that stays.
  void fill(std::span<const std::byte> bytes);

  /// Replaces the content by one that serves this frame.
  void stream(std::span<const std::byte> bytes);

 private:
  unsigned id_ = 0;
};

/// What a draw call reads, and how.
class GlVertexArray {
 public:
  GlVertexArray();
  ~GlVertexArray();

  GlVertexArray(GlVertexArray&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

  GlVertexArray& operator=(GlVertexArray&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }

  void bind() const;

  /// Reads attribute `place` as `parts` floats from `buffer`; `each` is 0 for a vertex's, 1 for an
  /// instance's.
  void floats(unsigned place, int parts, const GlBuffer& buffer, std::size_t stride,
              std::size_t offset, unsigned each) const;

  /// Reads attribute `place` as a color of four bytes.
  void color(unsigned place, const GlBuffer& buffer, std::size_t stride, std::size_t offset,
             unsigned each) const;

  void indices(const GlBuffer& buffer) const;

 private:
  unsigned id_ = 0;
};

/// A vertex and a fragment shader, linked.
class GlProgram {
 public:
  /// \errors ErrorKind::unsupported with the compiler's words: a fault of the driver or of ours.
  GlProgram(const std::string& name, const std::string& vertex, const std::string& fragment);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const;
  void set(const char* name, float value) const;
  void set(const char* name, int value) const;
  void set(const char* name, float x, float y) const;
  void set(const char* name, std::span<const float, 3> value) const;
  void set(const char* name, std::span<const float, 4> value) const;
  void set(const char* name, std::span<const float, 16> columns) const;

 private:
  unsigned id_ = 0;
};

/// Throws if the device ran out of memory since the last call; other faults are asserted against.
/// \errors ErrorKind::out_of_memory.
void check_device(const std::string& doing);

}  // namespace soms::view
