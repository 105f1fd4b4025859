// amalgam-report: error against run time.
#include <cstdlib>
#include <iostream>

#include "common/log.h"
#include "report/report_options.h"
#include "report/report_run.h"

int main(int argc, char** argv) {
  try {
    const auto options = amalgam::report::parse_report_options(argc, argv);
    if (!options) return EXIT_SUCCESS;
    amalgam::common::set_log_level("warn");
    amalgam::report::make_report(*options);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "amalgam-report: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
