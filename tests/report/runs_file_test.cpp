#include "report/runs_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "bench/povray/temporary_folder.h"
#include "report/whole_file.h"

namespace amalgam::report {
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using testing::ThrowsMessage;

RunRow sample_row(std::uint64_t run) {
  RunRow row;
  row.commit = "abc, \"dirty\"";
  row.host_cpu = "A CPU";
  row.threads = 2;
  row.scene = "glass bunny";
  row.width = 320;
  row.height = 240;
  row.sweep = "cut-off";
  row.point = "0.05";
  row.importance_cutoff = 0.05;
  row.run = run;
  row.time_ms = 12.5;
  row.mae = 1.0 / 3.0;
  row.rays_lookup = 1234567890123;
  row.truncation_bound_worst = 0.75;
  return row;
}

class Runs : public testing::Test {
 protected:
  bench::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "runs.csv";
};

TEST_F(Runs, ARowSurvives) {
  const RunRow row = sample_row(3);
  const RunRow read = parse_run_row(to_csv(row));
  EXPECT_EQ(to_csv(read), to_csv(row));
  EXPECT_EQ(read.commit, row.commit);
  EXPECT_EQ(read.mae, row.mae);
  EXPECT_EQ(read.rays_lookup, row.rays_lookup);
  EXPECT_EQ(read.truncation_bound_worst, 0.75);
  EXPECT_TRUE(std::isnan(read.limit_mae));
  EXPECT_THROW(parse_run_row({"too", "few"}), std::invalid_argument);
}

// No two columns are the same number under two names.
TEST_F(Runs, EveryColumnIsItsOwn) {
  const CsvRow names = run_columns();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  CsvRow fields(names.size());
  for (std::size_t i = 0; i < fields.size(); ++i) fields[i] = std::to_string(i + 1);
  EXPECT_EQ(to_csv(parse_run_row(fields)), fields);
}

TEST_F(Runs, GoesOnWhereItEnded) {
  {
    RunsFile file(path_);
    file.append(sample_row(0));
    file.append(sample_row(1));
  }
  RunsFile file(path_);
  EXPECT_THAT(file.rows(), SizeIs(2));
  EXPECT_TRUE(file.has(run_key(sample_row(1))));
  EXPECT_FALSE(file.has(run_key(sample_row(2))));
}

// A kill may leave any part of a row, the head's too.
TEST_F(Runs, AHalfRowIsDropped) {
  {
    RunsFile file(path_);
    file.append(sample_row(0));
    file.append(sample_row(1));
  }
  const std::string whole = read_whole_file(path_);
  const std::size_t head = csv_line(run_columns()).size();
  const std::size_t row = csv_line(to_csv(sample_row(1))).size();
  for (const std::size_t lost : {std::size_t{1}, row / 2, row - 1}) {
    std::ofstream(path_, std::ios::binary) << whole.substr(0, whole.size() - lost);
    RunsFile file(path_);
    EXPECT_THAT(file.rows(), SizeIs(1)) << lost;
    EXPECT_FALSE(file.has(run_key(sample_row(1)))) << lost;
    file.append(sample_row(1));
    EXPECT_EQ(read_whole_file(path_), whole) << lost;
  }
  std::ofstream(path_, std::ios::binary) << whole.substr(0, head / 2);
  RunsFile file(path_);
  EXPECT_THAT(file.rows(), SizeIs(0));
  EXPECT_EQ(read_whole_file(path_).size(), head);
}

// Appended rows are on disk at once, not when the file is closed.
TEST_F(Runs, RowsAreFlushed) {
  RunsFile file(path_);
  file.append(sample_row(0));
  EXPECT_THAT(read_whole_file(path_), HasSubstr("glass bunny"));
}

TEST_F(Runs, OtherFilesAreLeftAlone) {
  std::ofstream(path_) << "somebody,else\n1,2\n";
  EXPECT_THAT([&] { RunsFile file(path_); },
              ThrowsMessage<std::runtime_error>(HasSubstr("other columns")));
  EXPECT_EQ(read_whole_file(path_), "somebody,else\n1,2\n");
  EXPECT_THAT([&] { RunsFile file(folder_.path() / "none" / "runs.csv"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("cannot be written")));
}

TEST_F(Runs, RowsOfAnotherMachineDoNotMix) {
  RunsFile file(path_);
  file.append(sample_row(0));
  file.check_like(sample_row(1));
  const auto refused = [&](const auto& change) {
    RunRow row = sample_row(1);
    change(row);
    EXPECT_THROW(file.check_like(row), std::runtime_error);
  };
  refused([](RunRow& row) { row.commit = "other"; });
  refused([](RunRow& row) { row.host_cpu = "other"; });
  refused([](RunRow& row) { row.isa = "other"; });
  refused([](RunRow& row) { row.threads = 3; });
  refused([](RunRow& row) { row.height = 1; });
  refused([](RunRow& row) { row.reference = "other"; });
  RunRow of_another_point = sample_row(1);
  of_another_point.point = "0.1";
  of_another_point.reference = "other";
  file.check_like(of_another_point);
}

}  // namespace
}  // namespace amalgam::report
