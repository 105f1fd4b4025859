#include "gl/query.h"

#include <utility>

namespace amalgam::gl {

AnySamplesQuery::AnySamplesQuery() {
  glCreateQueries(GL_ANY_SAMPLES_PASSED, 1, &id_);
}

AnySamplesQuery::~AnySamplesQuery() {
  if (id_ != 0) glDeleteQueries(1, &id_);
}

AnySamplesQuery::AnySamplesQuery(AnySamplesQuery&& other) noexcept
    : id_(std::exchange(other.id_, 0)) {}

AnySamplesQuery& AnySamplesQuery::operator=(AnySamplesQuery&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

void AnySamplesQuery::begin() const {
  glBeginQuery(GL_ANY_SAMPLES_PASSED, id_);
}

void AnySamplesQuery::end() const {
  glEndQuery(GL_ANY_SAMPLES_PASSED);
}

bool AnySamplesQuery::wait() const {
  GLuint any = 0;
  glGetQueryObjectuiv(id_, GL_QUERY_RESULT, &any);
  return any != 0;
}

}  // namespace amalgam::gl
