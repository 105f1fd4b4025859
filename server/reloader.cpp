#include "server/reloader.h"

#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "common/log.h"
#include "frame/scene_renderer.h"
#include "net/tls.h"
#include "scene/gltf/loader.h"

namespace amalgam {

void Reloader::reload() {
  try {
    ServerOptions options = options_();
    net::make_tls_context(options.net.tls);  // throws before anything has changed
    common::log_info("reloading " + options.scene);
    // Waits for an earlier one that is still loading.
    loading_ = std::jthread([this, options = std::move(options)] { load(options); });
  } catch (const std::exception& error) {
    server_.reload_ended(error.what());
  }
}

void Reloader::load(const ServerOptions& options) {
  try {
    auto make = frame::renderer_of_scene(scene::load_scene(options.scene), options.render.renderer);
    service_.replace_renderer(std::move(make), [this, options](std::optional<std::string> error) {
      server_.post([this, options, error] {
        if (error) return server_.reload_ended(error);
        try {
          server_.configure(options.net);
          common::set_log_level(options.log_level);
          common::set_log_format(options.log_format);
          server_.reload_ended(std::nullopt);
        } catch (const std::exception& failure) {
          server_.reload_ended(failure.what());
        }
      });
    });
  } catch (const std::exception& error) {
    server_.post([this, what = std::string(error.what())] { server_.reload_ended(what); });
  }
}

}  // namespace amalgam
