// Owns one OpenGL query: did anything drawn while it ran pass all tests?
#pragma once

#include <epoxy/gl.h>

namespace amalgam::gl {

class AnySamplesQuery {
 public:
  AnySamplesQuery();
  ~AnySamplesQuery();
  AnySamplesQuery(AnySamplesQuery&& other) noexcept;
  AnySamplesQuery& operator=(AnySamplesQuery&& other) noexcept;
  AnySamplesQuery(const AnySamplesQuery&) = delete;
  AnySamplesQuery& operator=(const AnySamplesQuery&) = delete;

  void begin() const;
  void end() const;
  bool wait() const;  // for the answer of the last begin and end

 private:
  GLuint id_ = 0;
};

}  // namespace amalgam::gl
