// The client's final summary, for people and for scripts.
#pragma once

#include <string>

#include "client/viewer.h"

namespace amalgam::client {

std::string summary_text(const ViewerSummary& summary);  // several lines
std::string summary_json(const ViewerSummary& summary);  // one object, one line

}  // namespace amalgam::client
