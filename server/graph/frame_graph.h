// The frame graph: passes declare what they read and write, and only passes that the output needs
// run.
//
// Passes are left out by one mechanism: a resource may be *absent, with a reason*. A pass that
// needs an absent resource is left out for that reason, and its outputs are absent for the same
// reason. Absence has three sources: a scene that lacks a feature (absent()), a pass that finds at
// run time that it has nothing to give (Access::leave_empty), and the walk back from the output,
// which never reaches an unread resource. Evaluation is by demand, so "decode the camera image only
// if something is composited" follows without a rule for it.
//
// Absence is always explicit. An unset handle is a forgotten connection: giving it to a pass, or
// asking the graph for it, fails a check that names the pass.
//
// A graph lives for one frame on one thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <typeindex>
#include <typeinfo>
#include <utility>
#include <vector>

#include "common/log.h"
#include "core/progress.h"
#include "core/timings.h"

namespace amalgam::graph {

template <typename T>
class Handle {
 public:
  Handle() = default;  // unset, until a pass's output, import() or absent() is assigned to it

 private:
  friend class FrameGraph;
  friend class Builder;
  friend class Access;
  explicit Handle(int index) : index_(index) {}
  int index_ = -1;
};

struct PassReport {
  std::string name{};
  bool ran = false;
  std::string reason{};       // why it was left out; empty if it ran
  double milliseconds = 0.0;  // of the pass alone, without its inputs
};

class FrameGraph;
class Access;

// A pass's declaration while it is added.
class Builder {
 public:
  // The pass is left out if this is absent.
  template <typename T>
  void needs(Handle<T> handle);
  // Made available first if possible; the pass also runs without it.
  template <typename T>
  void uses(Handle<T> handle);
  // Of all handles given to needs_any(), at least one must be available; otherwise the pass is left
  // out for the first one's reason.
  template <typename T>
  void needs_any(Handle<T> handle);
  template <typename T>
  [[nodiscard]] Handle<T> writes(std::string resource);
  // The work itself, done at most once. It may capture the handles.
  void runs(std::function<void(const Access&)> execute);

 private:
  friend class FrameGraph;
  Builder(FrameGraph& graph, int pass) : graph_(graph), pass_(pass) {}
  FrameGraph& graph_;
  int pass_;
};

// A pass's access to resources while it runs: only to those that it declared.
class Access {
 public:
  template <typename T>
  const T& get(Handle<T> handle) const;
  // For handles given to uses() or needs_any(): null if absent.
  template <typename T>
  const T* find(Handle<T> handle) const;
  // The value, to be changed and passed on. Moved if no later pass reads it (peek() then sees a
  // moved-from value), otherwise copied.
  template <typename T>
  T take(Handle<T> handle) const;
  // The same for one member of it.
  template <typename T, typename Member>
  Member take(Handle<T> handle, Member T::*member) const;
  template <typename T>
  void set(Handle<T> handle, T value) const;
  // The pass has nothing to write: passes that need the resource are left out for this reason.
  template <typename T>
  void leave_empty(Handle<T> handle, std::string reason) const;

 private:
  friend class FrameGraph;
  Access(FrameGraph& graph, int pass) : graph_(graph), pass_(pass) {}
  FrameGraph& graph_;
  int pass_;
};

class FrameGraph {
 public:
  // Stepped before each pass, which may cancel the frame. May be null.
  void watch(core::Progress* progress) { progress_ = progress; }

  // A resource that exists already.
  template <typename T>
  Handle<T> import(std::string name, T value) {
    const Handle<T> handle(add_resource(std::move(name), typeid(T), kNoPass));
    store(handle.index_, std::make_shared<T>(std::move(value)));
    return handle;
  }

  // A resource that this frame or scene does not have.
  template <typename T>
  Handle<T> absent(std::string name, std::string reason) {
    const Handle<T> handle(add_resource(std::move(name), typeid(T), kNoPass));
    make_absent(handle.index_, std::move(reason));
    return handle;
  }

  // The pass declares its reads and writes, and then its work, through the builder.
  [[nodiscard]] Builder add_pass(std::string name);

  // A line in the pass list for work that is known in advance to be unnecessary (cached, for
  // instance).
  void note_left_out(std::string name, std::string reason);

  // Runs the passes that the resource needs, and no others. Null if it is absent.
  template <typename T>
  const T* realise(Handle<T> handle) {
    check_set(handle, kNoPass);
    return make_available(handle.index_) ? value<T>(handle.index_) : nullptr;
  }

  // The value if it has been made already; runs nothing. For statistics and dumps.
  template <typename T>
  const T* peek(Handle<T> handle) const {
    check_set(handle, kNoPass);
    return value<T>(handle.index_);
  }

  // Why a resource is absent, after realise() gave null.
  template <typename T>
  std::string reason_absent(Handle<T> handle) const {
    check_set(handle, kNoPass);
    return resources_[static_cast<std::size_t>(handle.index_)].reason;
  }

  // One entry for each pass, in the order in which they were added.
  std::vector<PassReport> reports() const;

  // The graph in Graphviz's language: boxes are passes (dashed: left out), ellipses are resources.
  std::string to_graphviz() const;

 private:
  friend class Builder;
  friend class Access;
  static constexpr int kNoPass = -1;

  enum class State : std::uint8_t { Unknown, Available, Absent };
  struct Resource {
    std::string name;
    std::type_index type;
    int producer = kNoPass;
    State state = State::Unknown;
    std::shared_ptr<void> value{};
    std::string reason{};
  };
  enum class Need : std::uint8_t { Required, Alternative, Optional };
  struct Read {
    int resource = -1;
    Need need = Need::Optional;
  };
  struct Pass {
    PassReport report{};
    std::function<void(const Access&)> execute{};
    std::vector<Read> reads{};
    std::vector<int> writes{};
    bool visited = false;
  };

  int add_resource(std::string name, std::type_index type, int producer);
  void add_read(int pass, int resource, Need need);
  void store(int resource, std::shared_ptr<void> value);
  void make_absent(int resource, std::string reason);
  bool make_available(int resource);
  void run(Pass& pass, int index);
  void leave_out(Pass& pass, const std::string& reason);
  void check_set(bool set, int pass, const std::type_info& type) const;
  void check_declared(bool declared, const char* verb, int pass, int resource) const;
  bool declares_read(int pass, int resource) const;
  bool declares_write(int pass, int resource) const;
  bool is_read_later(int resource) const;  // by a pass that has not been visited

  // pass: the one that was given the handle; kNoPass: the graph itself.
  template <typename T>
  void check_set(Handle<T> handle, int pass) const {
    check_set(handle.index_ >= 0, pass, typeid(T));
  }

  template <typename T>
  const T* value(int resource) const {
    const Resource& r = resources_[static_cast<std::size_t>(resource)];
    AMALGAM_CHECK(r.type == std::type_index(typeid(T)), "resource " + r.name);
    return static_cast<const T*>(r.value.get());
  }

  std::vector<Resource> resources_;
  core::Progress* progress_ = nullptr;
  std::vector<Pass> passes_;
};

template <typename T>
void Builder::needs(Handle<T> handle) {
  graph_.check_set(handle, pass_);
  graph_.add_read(pass_, handle.index_, FrameGraph::Need::Required);
}

template <typename T>
void Builder::uses(Handle<T> handle) {
  graph_.check_set(handle, pass_);
  graph_.add_read(pass_, handle.index_, FrameGraph::Need::Optional);
}

template <typename T>
void Builder::needs_any(Handle<T> handle) {
  graph_.check_set(handle, pass_);
  graph_.add_read(pass_, handle.index_, FrameGraph::Need::Alternative);
}

template <typename T>
Handle<T> Builder::writes(std::string resource) {
  return Handle<T>(graph_.add_resource(std::move(resource), typeid(T), pass_));
}

template <typename T>
const T& Access::get(Handle<T> handle) const {
  graph_.check_set(handle, pass_);
  graph_.check_declared(graph_.declares_read(pass_, handle.index_), "reads", pass_, handle.index_);
  const T* value = graph_.value<T>(handle.index_);
  AMALGAM_CHECK(value != nullptr, "read of an absent resource");
  return *value;
}

template <typename T>
const T* Access::find(Handle<T> handle) const {
  graph_.check_set(handle, pass_);
  graph_.check_declared(graph_.declares_read(pass_, handle.index_), "reads", pass_, handle.index_);
  return graph_.value<T>(handle.index_);
}

template <typename T>
T Access::take(Handle<T> handle) const {
  const T& value = get(handle);
  if constexpr (std::is_copy_constructible_v<T>) {
    if (graph_.is_read_later(handle.index_)) return value;
  } else {
    AMALGAM_CHECK(!graph_.is_read_later(handle.index_), "taken before its last reader");
  }
  return std::move(const_cast<T&>(value));  // stored as non-const (FrameGraph::store)
}

template <typename T, typename Member>
Member Access::take(Handle<T> handle, Member T::*member) const {
  const Member& value = get(handle).*member;
  if (graph_.is_read_later(handle.index_)) return value;
  return std::move(const_cast<Member&>(value));
}

template <typename T>
void Access::set(Handle<T> handle, T value) const {
  graph_.check_set(handle, pass_);
  graph_.check_declared(graph_.declares_write(pass_, handle.index_), "writes", pass_,
                        handle.index_);
  graph_.store(handle.index_, std::make_shared<T>(std::move(value)));
}

template <typename T>
void Access::leave_empty(Handle<T> handle, std::string reason) const {
  graph_.check_set(handle, pass_);
  graph_.check_declared(graph_.declares_write(pass_, handle.index_), "writes", pass_,
                        handle.index_);
  graph_.make_absent(handle.index_, std::move(reason));
}

}  // namespace amalgam::graph
