#include "graph/frame_graph.h"

#include <algorithm>
#include <sstream>

namespace amalgam::graph {

Builder FrameGraph::add_pass(std::string name) {
  passes_.push_back({.report = {.name = std::move(name)}});
  return {*this, static_cast<int>(passes_.size()) - 1};
}

void Builder::runs(std::function<void(const Access&)> execute) {
  graph_.passes_[static_cast<std::size_t>(pass_)].execute = std::move(execute);
}

void FrameGraph::note_left_out(std::string name, std::string reason) {
  passes_.push_back(
      {.report = {.name = std::move(name), .reason = std::move(reason)}, .execute = {}});
  passes_.back().visited = true;
}

int FrameGraph::add_resource(std::string name, std::type_index type, int producer) {
  const int index = static_cast<int>(resources_.size());
  resources_.push_back({.name = std::move(name), .type = type, .producer = producer});
  if (producer != kNoPass) passes_[static_cast<std::size_t>(producer)].writes.push_back(index);
  return index;
}

void FrameGraph::add_read(int pass, int resource, Need need) {
  passes_[static_cast<std::size_t>(pass)].reads.push_back({resource, need});
}

void FrameGraph::store(int resource, std::shared_ptr<void> value) {
  Resource& r = resources_[static_cast<std::size_t>(resource)];
  r.value = std::move(value);
  r.state = State::Available;
}

void FrameGraph::make_absent(int resource, std::string reason) {
  Resource& r = resources_[static_cast<std::size_t>(resource)];
  r.state = State::Absent;
  r.reason = std::move(reason);
}

// The walk back from the output. A pass is visited at most once. Its required inputs are made in
// the order of declaration; the first absent one stops it before costlier inputs are made.
bool FrameGraph::make_available(int resource) {
  const auto index = static_cast<std::size_t>(resource);
  if (resources_[index].state == State::Unknown) {
    const int producer = resources_[index].producer;
    Pass& pass = passes_[static_cast<std::size_t>(producer)];
    AMALGAM_CHECK(!pass.visited, "pass '" + pass.report.name + "' waits for itself through '" +
                                     resources_[index].name + "'");
    run(pass, producer);
  }
  return resources_[index].state == State::Available;
}

void FrameGraph::run(Pass& pass, int index) {
  pass.visited = true;
  const Read* first_alternative = nullptr;
  bool any_alternative = false;
  for (const Read& read : pass.reads) {
    if (read.need == Need::Required && !make_available(read.resource)) {
      leave_out(pass, resources_[static_cast<std::size_t>(read.resource)].reason);
      return;
    }
  }
  for (const Read& read : pass.reads) {
    if (read.need != Need::Alternative) continue;
    if (first_alternative == nullptr) first_alternative = &read;
    any_alternative = make_available(read.resource) || any_alternative;
  }
  if (first_alternative != nullptr && !any_alternative) {
    leave_out(pass, resources_[static_cast<std::size_t>(first_alternative->resource)].reason);
    return;
  }
  for (const Read& read : pass.reads) {
    if (read.need == Need::Optional) make_available(read.resource);
  }
  if (progress_ != nullptr) progress_->step();
  const core::Stopwatch stopwatch;
  pass.execute(Access(*this, index));
  pass.report.milliseconds = stopwatch.milliseconds();
  pass.report.ran = true;
  for (const int written : pass.writes) {
    const Resource& r = resources_[static_cast<std::size_t>(written)];
    AMALGAM_CHECK(r.state != State::Unknown,
                  "pass '" + pass.report.name + "' did not write '" + r.name + "'");
  }
}

void FrameGraph::leave_out(Pass& pass, const std::string& reason) {
  pass.report.reason = reason;
  for (const int written : pass.writes) make_absent(written, reason);
}

std::vector<PassReport> FrameGraph::reports() const {
  std::vector<PassReport> reports;
  for (const Pass& pass : passes_) {
    reports.push_back(pass.report);
    if (pass.visited) continue;
    // Never reached: give the absence that made it unnecessary, or that nothing reads it.
    std::string reason = "nothing reads its result";
    for (const Pass& reader : passes_) {
      const bool reads_it =
          std::any_of(reader.reads.begin(), reader.reads.end(), [&](const Read& r) {
            return std::find(pass.writes.begin(), pass.writes.end(), r.resource) !=
                   pass.writes.end();
          });
      if (reads_it && !reader.report.reason.empty()) {
        reason = reader.report.reason;
        break;
      }
    }
    reports.back().reason = reason;
  }
  return reports;
}

std::string FrameGraph::to_graphviz() const {
  std::ostringstream dot;
  dot << "digraph frame {\n  rankdir=LR;\n";
  for (std::size_t p = 0; p < passes_.size(); ++p) {
    const Pass& pass = passes_[p];
    dot << "  p" << p << " [shape=box,label=\"" << pass.report.name << "\""
        << (pass.report.ran ? "" : ",style=dashed") << "];\n";
    for (const Read& read : pass.reads) {
      dot << "  r" << read.resource << " -> p" << p
          << (read.need == Need::Required ? "" : " [style=dotted]") << ";\n";
    }
    for (const int written : pass.writes) dot << "  p" << p << " -> r" << written << ";\n";
  }
  for (std::size_t r = 0; r < resources_.size(); ++r) {
    dot << "  r" << r << " [label=\"" << resources_[r].name << "\""
        << (resources_[r].state == State::Available ? "" : ",style=dashed") << "];\n";
  }
  dot << "}\n";
  return dot.str();
}

bool FrameGraph::declares_read(int pass, int resource) const {
  const auto& reads = passes_[static_cast<std::size_t>(pass)].reads;
  return std::any_of(reads.begin(), reads.end(),
                     [&](const Read& r) { return r.resource == resource; });
}

bool FrameGraph::declares_write(int pass, int resource) const {
  const auto& writes = passes_[static_cast<std::size_t>(pass)].writes;
  return std::find(writes.begin(), writes.end(), resource) != writes.end();
}

bool FrameGraph::is_read_later(int resource) const {
  for (std::size_t p = 0; p < passes_.size(); ++p) {
    if (!passes_[p].visited && declares_read(static_cast<int>(p), resource)) return true;
  }
  return false;
}

void FrameGraph::check_set(bool set, int pass, const std::type_info& type) const {
  AMALGAM_CHECK(set, (pass == kNoPass
                          ? std::string("the graph")
                          : "pass '" + passes_[static_cast<std::size_t>(pass)].report.name + "'") +
                         " was given an unset handle of type " + type.name() +
                         "; what a frame does not have must be absent(), with a reason");
}

void FrameGraph::check_declared(bool declared, const char* verb, int pass, int resource) const {
  AMALGAM_CHECK(declared, "pass '" + passes_[static_cast<std::size_t>(pass)].report.name + "' " +
                              verb + " resource " + std::to_string(resource) +
                              " without declaring it");
}

}  // namespace amalgam::graph
