// runs.csv: rows are appended one by one and flushed, so that a run that is cut off loses at most
// the row in hand. Opened again, it goes on where it ended.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "report/run_row.h"

namespace amalgam::report {

class RunsFile {
 public:
  // A new file gets its head. Of an old one a half row at the end is dropped. Throws
  // std::runtime_error if the file cannot be written, or if it is not one of these.
  explicit RunsFile(std::filesystem::path path);

  const std::vector<RunRow>& rows() const { return rows_; }
  bool has(const std::string& key) const { return keys_.contains(key); }
  void append(const RunRow& row);

  // Throws std::runtime_error if a row was measured elsewhere or otherwise: one of another commit,
  // processor, instruction set, number of threads or size, or of the same setting with another
  // reference, would be compared with this one.
  void check_like(const RunRow& row) const;

 private:
  std::filesystem::path path_;
  std::vector<RunRow> rows_;
  std::set<std::string> keys_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, &std::fclose};
};

}  // namespace amalgam::report
