// Reports OpenGL's errors.
#pragma once

#include <string>

namespace amalgam::gl {

// Logs every error that the driver reports. In debug builds an error ends the program at the faulty
// call.
void report_gl_errors();

// Throws std::runtime_error if an error is pending, such as GL_OUT_OF_MEMORY after an allocation.
// The error is not pending any more then.
void throw_pending_gl_error(const std::string& doing);

}  // namespace amalgam::gl
