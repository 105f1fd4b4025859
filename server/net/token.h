// Compares the shared secret that admits clients. The time taken reveals nothing about it.
#pragma once

#include <string_view>

namespace amalgam::net {

bool tokens_equal(std::string_view given, std::string_view expected);

}  // namespace amalgam::net
