// Owns one linked OpenGL program. All its inputs have explicit locations or bindings from
// shader_interface.h, so nothing is looked up by name.
#pragma once

#include <epoxy/gl.h>

#include <string>
#include <string_view>

namespace amalgam::gl {

class ShaderProgram {
 public:
  // vertex_file, fragment_file: names of embedded shader files. defines: lines inserted after
  // "#version". Throws std::runtime_error with the compiler's log and the file.
  ShaderProgram(std::string_view vertex_file, std::string_view fragment_file,
                const std::string& defines = {});
  ~ShaderProgram();
  ShaderProgram(ShaderProgram&& other) noexcept;
  ShaderProgram& operator=(ShaderProgram&& other) noexcept;
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  void use() const;
  void set(GLint location, GLuint value) const;
  void set(GLint location, GLint value) const;
  void set(GLint location, GLfloat value) const;

 private:
  GLuint id_ = 0;
};

}  // namespace amalgam::gl
