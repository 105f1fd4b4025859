#include "report/runs_file.h"

#include <stdexcept>
#include <tuple>
#include <utility>

#include "report/whole_file.h"

namespace amalgam::report {
namespace {

namespace fs = std::filesystem;

std::string cannot_write(const fs::path& path) {
  return path.string() + " cannot be written";
}

}  // namespace

RunsFile::RunsFile(fs::path path) : path_(std::move(path)) {
  std::error_code error;
  CsvText text;
  if (fs::exists(path_, error)) {
    text = parse_csv(read_whole_file(path_));
    if (!text.rows.empty() && text.rows.front() != run_columns()) {
      throw std::runtime_error(path_.string() +
                               " has other columns: remove it, or choose another "
                               "--output");
    }
    fs::resize_file(path_, text.whole_size, error);
    if (error) throw std::runtime_error(cannot_write(path_));
    for (std::size_t i = 1; i < text.rows.size(); ++i) {
      rows_.push_back(parse_run_row(text.rows[i]));
      keys_.insert(run_key(rows_.back()));
    }
  }
  file_.reset(std::fopen(path_.c_str(), "ab"));
  if (!file_) throw std::runtime_error(cannot_write(path_));
  if (text.rows.empty()) {
    const std::string head = csv_line(run_columns());
    if (std::fputs(head.c_str(), file_.get()) < 0 || std::fflush(file_.get()) != 0) {
      throw std::runtime_error(cannot_write(path_));
    }
  }
}

void RunsFile::append(const RunRow& row) {
  const std::string line = csv_line(to_csv(row));
  if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size() ||
      std::fflush(file_.get()) != 0) {
    throw std::runtime_error(cannot_write(path_));
  }
  rows_.push_back(row);
  keys_.insert(run_key(row));
}

void RunsFile::check_like(const RunRow& row) const {
  for (const RunRow& old : rows_) {
    const auto check = [&](const auto& ours, const auto& theirs, const char* what) {
      if (ours == theirs) return;
      throw std::runtime_error(path_.string() + " has rows of another " + what +
                               ": remove it, or choose another --output");
    };
    check(row.commit, old.commit, "commit");
    check(row.host_cpu, old.host_cpu, "processor");
    check(row.isa, old.isa, "instruction set");
    check(row.threads, old.threads, "number of threads");
    if (row.scene == old.scene) {
      check(std::pair(row.width, row.height), std::pair(old.width, old.height), "size");
    }
    if (std::tie(row.scene, row.sweep, row.point) == std::tie(old.scene, old.sweep, old.point)) {
      check(row.reference, old.reference, "reference");
    }
  }
}

}  // namespace amalgam::report
