// Programs that are not ours, run by the shell: POV-Ray, gnuplot, git.
#pragma once

#include <filesystem>
#include <string>

namespace amalgam::bench {

// What a shell command prints on standard output; its exit status is told by what it printed.
// Throws std::runtime_error without a shell.
std::string output_of(const std::string& command);

// As one word of a command.
std::string quoted(const std::filesystem::path& path);

}  // namespace amalgam::bench
