#include "truth/truth_case.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

namespace amalgam::truth {
namespace {

const std::string kRoot = AMALGAM_SOURCE_DIR "/";
const std::string kFolder = kRoot + "tests/truth/";

nlohmann::json read_json(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return nlohmann::json::parse(file);
}

const nlohmann::json& settings() {
  static const nlohmann::json kSettings = read_json(kFolder + "cases.json");
  return kSettings;
}

common::CameraModel camera_of(const nlohmann::json& json) {
  common::CameraModel camera;
  camera.width = json.at("width");
  camera.height = json.at("height");
  camera.fx = camera.fy = json.at("focal");
  camera.cx = json.at("cx");
  camera.cy = json.at("cy");
  return camera;
}

common::MarkerPose pose_of(const nlohmann::json& json) {
  const std::vector<double> r = json.at("rotation"), t = json.at("translation");
  return {json.at("marker"), glm::dquat(r.at(3), r.at(0), r.at(1), r.at(2)),
          glm::dvec3(t.at(0), t.at(1), t.at(2))};
}

common::ImageRgb8 read_png(const std::string& name) {
  const std::string path = kFolder + "pictures/" + name + ".png";
  const cv::Mat bgr = cv::imread(path, cv::IMREAD_COLOR);
  if (bgr.empty()) throw std::runtime_error(path + ": cannot be read");
  common::ImageRgb8 image(bgr.cols, bgr.rows);
  for (int y = 0; y < bgr.rows; ++y) {
    for (int x = 0; x < bgr.cols; ++x) {
      const auto& pixel = bgr.at<cv::Vec3b>(y, x);
      image.at(x, y) = {pixel[2], pixel[1], pixel[0]};
    }
  }
  return image;
}

}  // namespace

std::vector<TruthCase> truth_cases() {
  std::vector<TruthCase> cases;
  const nlohmann::json& camera = settings().at("camera");
  for (const nlohmann::json& json : settings().at("cases")) {
    cases.push_back({json.at("name"),
                     kRoot + "deploy/scenes/" + json.at("scene").get<std::string>() + ".gltf",
                     camera_of(camera), pose_of(camera.at("pose"))});
  }
  return cases;
}

std::vector<Environment> environments() {
  std::vector<Environment> list;
  for (const auto& [name, path] : settings().at("environments").items()) {
    list.push_back({name, kRoot + path.get<std::string>()});
  }
  return list;
}

TruthPair load_pair(const TruthCase& truth_case, const Environment& environment,
                    const std::string& kind) {
  static const nlohmann::json kNoise = read_json(kFolder + "pictures/noise.json");
  const std::string name = truth_case.name + "-" + environment.name + "-" + kind;
  return {name, environment, read_png(name + "-camera"), read_png(name + "-truth"),
          kNoise.at(name).at("mean")};
}

common::ImageRgb8 load_mask(const TruthCase& truth_case) {
  return read_png(truth_case.name + "-mask");
}

}  // namespace amalgam::truth
