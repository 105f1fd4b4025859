#include "scene/gltf/loader.h"

#include <algorithm>
#include <exception>
#include <map>

#include "common/one_line.h"
#include "scene/glass_winding.h"
#include "scene/gltf/accessor.h"
#include "scene/gltf/doubtful_extras.h"
#include "scene/gltf/environment_loader.h"
#include "scene/gltf/extras.h"
#include "scene/gltf/lights.h"
#include "scene/gltf/materials.h"
#include "scene/gltf/meshes.h"
#include "scene/gltf/model.h"
#include "scene/gltf/scene_folder.h"
#include "scene/gltf/transform.h"
#include "scene/likely_mistakes.h"

namespace amalgam::scene {
namespace {

// The meshes of the Scene that one glTF mesh became, and what they are made of.
using Parts = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // mesh, material

class SceneBuilder {
 public:
  explicit SceneBuilder(const GltfModel& gltf, Scene& scene)
      : gltf_(gltf), root_(gltf.document), scene_(scene) {
    if (const auto nodes = root_.find("nodes")) nodes_ = nodes->items();
    lights_ = read_lights(root_);
  }

  void build() {
    check_mesh_sizes(gltf_.model);
    check_accessor_data(gltf_.model, scene_.notes);
    ResolvedMaterials materials = resolve_materials(gltf_, scene_.textures, scene_.notes);
    // Every mesh is read, drawn or not: a file with a broken one is a broken file.
    for (std::size_t i = 0; i < gltf_.model.meshes.size(); ++i) {
      read_.push_back(read_primitives(gltf_, i, materials, scene_.notes));
    }
    scene_.materials = std::move(materials.materials);
    walk();
    drop_unused_materials();
  }

 private:
  struct Visit {
    int node = 0;
    glm::dmat4 anchor_from_parent{1.0};
    Role role = Role::Virtual;
    std::optional<int> marker;
  };

  std::vector<int> root_nodes() const {
    const tinygltf::Model& model = gltf_.model;
    if (!model.scenes.empty()) {
      return model.scenes[static_cast<std::size_t>(std::max(model.defaultScene, 0))].nodes;
    }
    std::vector<bool> is_child(model.nodes.size(), false);
    for (const auto& node : model.nodes) {
      for (const int child : node.children) is_child[static_cast<std::size_t>(child)] = true;
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) roots.push_back(static_cast<int>(i));
    }
    return roots;
  }

  // Depth first in file order, on a stack of our own: a file may nest deeper than the call stack.
  void walk() {
    std::vector<Visit> stack;
    const auto push = [&](const std::vector<int>& nodes, const Visit& inherited) {
      for (auto it = nodes.rbegin(); it != nodes.rend(); ++it) {
        stack.push_back(inherited);
        stack.back().node = *it;
      }
    };
    push(root_nodes(), Visit{});
    while (!stack.empty()) {
      Visit visit = stack.back();
      stack.pop_back();
      const auto index = static_cast<std::size_t>(visit.node);
      const NodeExtras extras = read_node_extras(nodes_[index]);
      // A marker's frame begins afresh: what stands above in the hierarchy belongs to another
      // marker.
      if (extras.marker && extras.marker != visit.marker)
        visit.anchor_from_parent = glm::dmat4(1.0);
      if (extras.role) visit.role = *extras.role;
      if (extras.marker) visit.marker = extras.marker;
      visit.anchor_from_parent *= parent_from_node(gltf_.model.nodes[index]);
      add_contents(index, visit);
      push(gltf_.model.nodes[index].children, visit);
    }
  }

  void add_contents(std::size_t index, const Visit& visit) {
    const tinygltf::Node& node = gltf_.model.nodes[index];
    const std::string name = node.name.empty() ? nodes_[index].path() : common::one_line(node.name);
    if (const auto light = node_light(nodes_[index], lights_.size())) {
      if (is_collapsed(visit.anchor_from_parent)) {
        scene_.notes.push_back(nodes_[index].path() +
                               ": is scaled to nothing, its light is left out");
        return;
      }
      check_transform_finite(visit.anchor_from_parent, nodes_[index].path());
      PunctualLight placed = lights_[*light];
      placed.node = name;
      placed.anchor_from_light = visit.anchor_from_parent;
      placed.marker = visit.marker;
      scene_.punctual_lights.push_back(std::move(placed));
    }
    if (node.mesh < 0) return;
    const Parts& parts = parts_of(static_cast<std::size_t>(node.mesh));
    if (parts.empty()) return;
    if (is_collapsed(visit.anchor_from_parent)) {
      scene_.notes.push_back(nodes_[index].path() + ": is scaled to nothing, not drawn");
      return;
    }
    check_transform_usable(visit.anchor_from_parent, nodes_[index].path());
    if (node.skin >= 0)
      scene_.notes.push_back(nodes_[index].path() + ": skin ignored, drawn as modelled");
    for (const auto& [mesh, material] : parts) {
      Instance instance;
      instance.node = name;
      instance.mesh = mesh;
      instance.material = material;
      instance.anchor_from_mesh = visit.anchor_from_parent;
      instance.marker = visit.marker;
      instance.role = visit.role;
      scene_.instances.push_back(std::move(instance));
    }
  }

  // Moves a glTF mesh into the scene when it is first met.
  const Parts& parts_of(std::size_t mesh) {
    const auto [entry, is_new] = parts_.try_emplace(mesh);
    if (is_new) {
      for (ReadPrimitive& primitive : read_[mesh]) {
        entry->second.emplace_back(static_cast<std::uint32_t>(scene_.meshes.size()),
                                   static_cast<std::uint32_t>(primitive.material));
        scene_.meshes.push_back(std::move(primitive.mesh));
      }
    }
    return entry->second;
  }

  // The default material was added in case a primitive names none.
  void drop_unused_materials() {
    const auto fallback = static_cast<std::uint32_t>(scene_.materials.size() - 1);
    const bool used =
        std::any_of(scene_.instances.begin(), scene_.instances.end(),
                    [&](const Instance& instance) { return instance.material == fallback; });
    if (!used) scene_.materials.pop_back();
  }

  const GltfModel& gltf_;
  JsonCursor root_;
  Scene& scene_;
  std::vector<JsonCursor> nodes_;
  std::vector<PunctualLight> lights_;
  std::vector<std::vector<ReadPrimitive>> read_;  // by glTF mesh
  std::map<std::size_t, Parts> parts_;            // by glTF mesh, those that are used
};

SceneExtras extras_of_default_scene(const GltfModel& gltf) {
  const auto scenes = JsonCursor(gltf.document).find("scenes");
  const auto all = scenes ? scenes->items() : std::vector<JsonCursor>{};
  if (all.empty()) return {};
  return read_scene_extras(all[static_cast<std::size_t>(std::max(gltf.model.defaultScene, 0))]);
}

Scene load_unnamed(const std::filesystem::path& path, const LoadOptions& options) {
  Scene scene;
  scene.path = path.string();
  const GltfModel gltf = load_gltf_model(path, scene.notes);
  const SceneExtras extras = extras_of_default_scene(gltf);
  scene.world = extras.world;
  SceneBuilder(gltf, scene).build();
  if (options.environment) {
    scene.environment = load_environment(*options.environment, scene.notes);
  } else if (options.load_environment && extras.environment) {
    scene.environment =
        load_environment(SceneFolder(path).resolve(*extras.environment), scene.notes);
  }
  turn_glass_outward(scene);
  const auto add = [&](std::vector<std::string> warnings) {
    scene.warnings.insert(scene.warnings.end(), warnings.begin(), warnings.end());
  };
  add(doubtful_extras(JsonCursor(gltf.document)));
  add(likely_mistakes(scene));
  // They quote names and texts of the file, which may end up in a log or on a terminal.
  for (auto* texts : {&scene.notes, &scene.warnings}) {
    for (std::string& text : *texts) text = common::one_line(text);
  }
  return scene;
}

}  // namespace

Scene load_scene(const std::filesystem::path& path, const LoadOptions& options) {
  try {
    return load_unnamed(path, options);
  } catch (const SceneError& caught) {
    const std::string what = caught.what();
    throw SceneError(
        common::one_line(what.starts_with(path.string()) ? what : path.string() + ": " + what));
  } catch (const std::bad_alloc&) {
    throw SceneError(path.string() + ": needs more memory than there is");
  }
}

}  // namespace amalgam::scene
