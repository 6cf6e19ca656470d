#include "apps/view/drawing/gl/gl_objects.h"

#include "soms/base/error.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace soms::view {

namespace {

// OpenGL takes offsets into buffers as pointers.
const void* as_pointer(std::size_t offset) {
  return reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr): its interface
}

void upload(unsigned id, std::span<const std::byte> bytes, GLenum use) {
  // Neither vertex arrays nor their index buffers are touched by this target.
  glBindBuffer(GL_COPY_WRITE_BUFFER, id);
  glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), use);
}

unsigned compile(const std::string& name, GLenum kind, const std::string& source) {
  const unsigned shader = glCreateShader(kind);
  const char* const text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint fine = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &fine);
  if (fine == GL_TRUE) {
    return shader;
  }
  std::string words(2000, '\0');
  GLsizei size = 0;
  glGetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), &size, words.data());
  words.resize(static_cast<std::size_t>(std::max(size, 0)));
  glDeleteShader(shader);
  throw Error(ErrorKind::unsupported, "OpenGL: shader " + name + " does not compile: " + words,
              "update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1");
}

int place_of(unsigned program, const char* name) {
  return glGetUniformLocation(program, name);
}

}  // namespace

GlBuffer::GlBuffer() {
  glGenBuffers(1, &id_);
}

GlBuffer::~GlBuffer() {
  if (id_ != 0) {
    glDeleteBuffers(1, &id_);
  }
}

void GlBuffer::fill(std::span<const std::byte> bytes) {
  upload(id_, bytes, GL_STATIC_DRAW);
}

void GlBuffer::stream(std::span<const std::byte> bytes) {
  upload(id_, bytes, GL_STREAM_DRAW);
}

GlVertexArray::GlVertexArray() {
  glGenVertexArrays(1, &id_);
}

GlVertexArray::~GlVertexArray() {
  if (id_ != 0) {
    glDeleteVertexArrays(1, &id_);
  }
}

void GlVertexArray::bind() const {
  glBindVertexArray(id_);
}

void GlVertexArray::floats(unsigned place, int parts, const GlBuffer& buffer, std::size_t stride,
                           std::size_t offset, unsigned each) const {
  glBindVertexArray(id_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, parts, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        as_pointer(offset));
  glVertexAttribDivisor(place, each);
}

void GlVertexArray::color(unsigned place, const GlBuffer& buffer, std::size_t stride,
                          std::size_t offset, unsigned each) const {
  glBindVertexArray(id_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, 4, GL_UNSIGNED_BYTE, GL_TRUE, static_cast<GLsizei>(stride),
                        as_pointer(offset));
  glVertexAttribDivisor(place, each);
}

void GlVertexArray::indices(const GlBuffer& buffer) const {
  glBindVertexArray(id_);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer.id());
}

GlProgram::GlProgram(const std::string& name, const std::string& vertex,
                     const std::string& fragment) {
  const unsigned first = compile(name, GL_VERTEX_SHADER, vertex);
  unsigned second = 0;
  try {
    second = compile(name, GL_FRAGMENT_SHADER, fragment);
  } catch (...) {
    glDeleteShader(first);
    throw;
  }
  id_ = glCreateProgram();
  glAttachShader(id_, first);
  glAttachShader(id_, second);
  glLinkProgram(id_);
  glDeleteShader(first);
  glDeleteShader(second);
  GLint fine = GL_FALSE;
  glGetProgramiv(id_, GL_LINK_STATUS, &fine);
  if (fine != GL_TRUE) {
    glDeleteProgram(id_);
    throw Error(ErrorKind::unsupported, "OpenGL: program " + name + " does not link",
                "update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1");
  }
}

GlProgram::~GlProgram() {
  glDeleteProgram(id_);
}

void GlProgram::use() const {
  glUseProgram(id_);
}

void GlProgram::set(const char* name, float value) const {
  glUniform1f(place_of(id_, name), value);
}

void GlProgram::set(const char* name, int value) const {
  glUniform1i(place_of(id_, name), value);
}

void GlProgram::set(const char* name, float x, float y) const {
  glUniform2f(place_of(id_, name), x, y);
}

void GlProgram::set(const char* name, std::span<const float, 3> value) const {
  glUniform3fv(place_of(id_, name), 1, value.data());
}

void GlProgram::set(const char* name, std::span<const float, 4> value) const {
  glUniform4fv(place_of(id_, name), 1, value.data());
}

void GlProgram::set(const char* name, std::span<const float, 16> columns) const {
  glUniformMatrix4fv(place_of(id_, name), 1, GL_FALSE, columns.data());
}

void check_device(const std::string& doing) {
  for (GLenum fault = glGetError(); fault != GL_NO_ERROR; fault = glGetError()) {
    if (fault == GL_OUT_OF_MEMORY) {
      throw Error(ErrorKind::out_of_memory, "OpenGL: out of memory " + doing,
                  "draw fewer triangles, a smaller picture, or fewer samples");
    }
    if (fault != GL_CONTEXT_LOST) {
      throw Error(ErrorKind::unsupported,
                  "OpenGL: the driver reports an error (" + std::to_string(fault) + ") " + doing,
                  "update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1");
    }
  }
}

}  // namespace soms::view
