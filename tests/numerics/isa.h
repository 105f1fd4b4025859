// Embree's instruction sets, for tests that compare them.
#pragma once

#include <cstdlib>
#include <string>

#include "trace/embree_isa.h"

namespace amalgam::test_support {

// Scenes that are built while this lives use the given instruction set.
class ChosenIsa {
 public:
  explicit ChosenIsa(const std::string& isa) { setenv(trace::kIsaVariable, isa.c_str(), 1); }
  ~ChosenIsa() { unsetenv(trace::kIsaVariable); }
  ChosenIsa(const ChosenIsa&) = delete;
  ChosenIsa& operator=(const ChosenIsa&) = delete;
};

}  // namespace amalgam::test_support
