#include "gl/shader_program.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "gl/shader_constants.h"
#include "shaders/shader_sources.h"

namespace amalgam::gl {
namespace {

// The source with defines and constants after its first line, which is "#version".
std::string assemble(std::string_view file, const std::string& defines) {
  const std::string_view source = shaders::source(file);
  const std::size_t first_line = source.find('\n') + 1;
  return std::string(source.substr(0, first_line)) + defines + shader_constants() +
         std::string(source.substr(first_line));
}

// Adds line numbers for the log, because includes shift the files' own.
std::string number_lines(const std::string& source) {
  std::istringstream lines(source);
  std::ostringstream numbered;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
    numbered << number << ": " << line << '\n';
  return numbered.str();
}

class Shader {
 public:
  Shader(GLenum stage, std::string_view file, const std::string& defines)
      : id_(glCreateShader(stage)) {
    const std::string source = assemble(file, defines);
    const GLchar* text = source.c_str();
    glShaderSource(id_, 1, &text, nullptr);
    glCompileShader(id_);
    GLint compiled = GL_FALSE;
    glGetShaderiv(id_, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return;
    std::array<GLchar, 4096> log{};
    glGetShaderInfoLog(id_, static_cast<GLsizei>(log.size()), nullptr, log.data());
    glDeleteShader(id_);
    throw std::runtime_error("shader " + std::string(file) + " does not compile: " + log.data() +
                             "\n" + number_lines(source));
  }
  ~Shader() { glDeleteShader(id_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

  GLuint id() const { return id_; }

 private:
  GLuint id_;
};

}  // namespace

ShaderProgram::ShaderProgram(std::string_view vertex_file, std::string_view fragment_file,
                             const std::string& defines) {
  const Shader vertex(GL_VERTEX_SHADER, vertex_file, defines);
  const Shader fragment(GL_FRAGMENT_SHADER, fragment_file, defines);
  id_ = glCreateProgram();
  glAttachShader(id_, vertex.id());
  glAttachShader(id_, fragment.id());
  glLinkProgram(id_);
  glDetachShader(id_, vertex.id());
  glDetachShader(id_, fragment.id());
  GLint linked = GL_FALSE;
  glGetProgramiv(id_, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  std::array<GLchar, 4096> log{};
  glGetProgramInfoLog(id_, static_cast<GLsizei>(log.size()), nullptr, log.data());
  glDeleteProgram(id_);
  throw std::runtime_error("shaders " + std::string(vertex_file) + " and " +
                           std::string(fragment_file) + " do not link: " + log.data());
}

ShaderProgram::~ShaderProgram() {
  if (id_ != 0) glDeleteProgram(id_);
}

ShaderProgram::ShaderProgram(ShaderProgram&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

ShaderProgram& ShaderProgram::operator=(ShaderProgram&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

void ShaderProgram::use() const {
  glUseProgram(id_);
}

void ShaderProgram::set(GLint location, GLuint value) const {
  glProgramUniform1ui(id_, location, value);
}

void ShaderProgram::set(GLint location, GLint value) const {
  glProgramUniform1i(id_, location, value);
}

void ShaderProgram::set(GLint location, GLfloat value) const {
  glProgramUniform1f(id_, location, value);
}

}  // namespace amalgam::gl
