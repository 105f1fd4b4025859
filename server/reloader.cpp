#include "server/reloader.h"

#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "common/log.h"
#include "frame/scene_renderer.h"
#include "scene/gltf/loader.h"

namespace amalgam {

void Reloader::reload() {
  if (busy_) {
    again_ = true;
    return;
  }
  busy_ = true;
  try {
    ServerOptions options = options_();
    Tls tls = net::make_tls_context(options.net.tls);  // throws before anything has changed
    common::log_info("reloading " + options.scene);
    // The last one has handed over its scene or failed, so assigning does not wait for its disk.
    loading_ = std::jthread(
        [this, options = std::move(options), tls = std::move(tls)] { load(options, tls); });
  } catch (const std::exception& error) {
    ended(error.what());
  }
}

void Reloader::load(const ServerOptions& options, const Tls& tls) {
  try {
    auto make = frame::renderer_of_scene(scene::load_scene(options.scene), options.render.renderer);
    service_.replace_renderer(std::move(make),
                              [this, options, tls](const std::optional<std::string>& error) {
                                server_.post([this, options, tls, error] {
                                  if (error) return ended(error);
                                  server_.configure(options.net, tls);
                                  common::set_log_level(options.log_level);
                                  common::set_log_format(options.log_format);
                                  ended(std::nullopt);
                                });
                              });
  } catch (const std::exception& error) {
    server_.post([this, what = std::string(error.what())] { ended(what); });
  }
}

void Reloader::ended(const std::optional<std::string>& error) {
  busy_ = false;
  server_.reload_ended(error);
  if (std::exchange(again_, false)) reload();
}

}  // namespace amalgam
