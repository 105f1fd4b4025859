#include "client/tracking/poses_file.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "common/whole_file.h"

namespace amalgam::client {
namespace {

const nlohmann::json& find_member(const nlohmann::json& object, const char* key,
                                  const std::string& where) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (!object.is_object() || found == object.end()) {
    throw std::runtime_error(where + " has no '" + key + "'");
  }
  return *found;
}

const nlohmann::json& list(const nlohmann::json& object, const char* key,
                           const std::string& where) {
  const nlohmann::json& found = find_member(object, key, where);
  if (!found.is_array()) throw std::runtime_error(where + ": '" + key + "' is not a list");
  return found;
}

// The member of an object, as a T; errors name the key and not the JSON library.
template <typename T>
T member(const nlohmann::json& object, const char* key, const std::string& where,
         const char* expected) {
  const nlohmann::json& found = find_member(object, key, where);
  try {
    return found.get<T>();
  } catch (const nlohmann::json::exception&) {
    throw std::runtime_error(where + ": '" + key + "' is not " + expected);
  }
}

nlohmann::json read_json(const std::filesystem::path& path) {
  constexpr std::size_t kMostBytes = std::size_t{16} << 20;
  nlohmann::json json =
      nlohmann::json::parse(common::read_whole_file(path, kMostBytes), nullptr, false);
  if (json.is_discarded()) throw std::runtime_error(path.string() + ": is not JSON");
  return json;
}

}  // namespace

std::vector<common::MarkerPose> load_poses(const std::filesystem::path& path) {
  const nlohmann::json json = read_json(path);
  // By reference: copies call themselves for each level, of which a file may have very many.
  const nlohmann::json& entries = list(json, "poses", path.string());
  std::vector<common::MarkerPose> poses;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string where = path.string() + ": poses[" + std::to_string(i) + "]";
    const auto r = member<std::vector<double>>(entries[i], "rotation", where, "4 numbers x y z w");
    const auto t = member<std::vector<double>>(entries[i], "translation", where, "3 numbers");
    if (r.size() != 4) throw std::runtime_error(where + ": 'rotation' is not 4 numbers x y z w");
    if (t.size() != 3) throw std::runtime_error(where + ": 'translation' is not 3 numbers");
    poses.push_back({member<int>(entries[i], "marker", where, "a number"),
                     glm::dquat(r[3], r[0], r[1], r[2]), glm::dvec3(t[0], t[1], t[2])});
  }
  for (const common::MarkerPose& pose : poses) {
    if (!common::is_usable(pose)) {
      throw std::runtime_error(path.string() + ": the pose of marker " +
                               std::to_string(pose.marker) +
                               " is no rotation and translation in metres");
    }
  }
  return poses;
}

nlohmann::ordered_json poses_json(const std::vector<common::MarkerPose>& poses) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const common::MarkerPose& pose : poses) {
    const glm::dquat& q = pose.rotation;
    const glm::dvec3& t = pose.translation;
    json.push_back({{"marker", pose.marker},
                    {"rotation", {q.x, q.y, q.z, q.w}},
                    {"translation", {t.x, t.y, t.z}}});
  }
  return json;
}

}  // namespace amalgam::client
