// Pictures by the double-precision renderer (support/reference), which take long, kept on disk as
// OpenEXR files. A file's name tells scene and size, and a hash of everything that the picture
// depends on.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "bench/bench_case.h"
#include "common/image.h"
#include "report/sweep_point.h"

namespace amalgam::report {

class ReferenceStore {
 public:
  // Makes the folder. rendering(what) is called before a picture that takes time.
  ReferenceStore(std::filesystem::path folder,
                 std::function<void(const std::string& what)> rendering);

  // The reference's float composite of the case's first pose. Throws std::runtime_error.
  const common::ImageRgb32f& composite(const bench::BenchCase& bench_case, double exposure,
                                       const ReferenceSpec& spec);

  // Mean absolute difference between the reference and one with a sample less a side, whose samples
  // all lie elsewhere: below a few times this, errors are the reference's own. NaN for references
  // of one sample.
  double floor(const bench::BenchCase& bench_case, double exposure, const ReferenceSpec& spec);

 private:
  std::string file_name(const bench::BenchCase& bench_case, double exposure,
                        const ReferenceSpec& spec);

  std::filesystem::path folder_;
  std::function<void(const std::string&)> rendering_;
  std::map<std::string, common::ImageRgb32f> pictures_;  // by file name
  std::map<std::filesystem::path, std::string> scenes_;  // hashes
};

}  // namespace amalgam::report
