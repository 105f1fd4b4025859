// The error of a method over all truth pictures.
#pragma once

#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <vector>

#include "truth/truth_rendering.h"

namespace amalgam::truth {

// Mean differences to the truth, in 1/255.
struct Error {
  double objects = 0.0;  // where objects are seen
  double real = 0.0;     // on real surfaces, where truth or composite differ from the camera image
};

using ErrorByPair = std::map<std::string, Error>;  // by TruthPair::name

// Cases whose scene is there; deploy/fetch_assets.sh makes the bunnies.
std::vector<TruthCase> cases_at_hand();

// Every scene at hand under these environments, by these kinds of pictures (kKinds). gains: of the
// camera's channels, its white balance, which Reinhard's curve can be given afterwards.
ErrorByPair errors_of(const Method& method, const std::vector<std::string>& kinds,
                      const glm::vec3& gains = glm::vec3(1.0f),
                      const std::vector<Environment>& lit_by = environments());

// Of the camera's image without any composite.
ErrorByPair errors_of_camera(const std::vector<std::string>& kinds);

Error mean_of(const ErrorByPair& errors);

}  // namespace amalgam::truth
