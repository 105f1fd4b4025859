#include "report/truth_part.h"

#include "truth/truth_errors.h"

namespace amalgam::report {
namespace {

const std::vector<std::string> kDirect{"direct-linear", "direct-reinhard"};
const std::vector<std::string> kFull{"full-linear", "full-reinhard"};

TruthRow row_of(const std::string& method, const truth::Error& direct, const truth::Error& full) {
  return {method, direct.objects, direct.real, full.objects, full.real};
}

}  // namespace

std::vector<TruthRow> measure_truth(bool quick,
                                    const std::function<void(const std::string&)>& say) {
  if (truth::cases_at_hand().empty()) return {};
  std::vector<truth::Method> methods{truth::of_the_thesis(), truth::by_default(),
                                     truth::with_64_lights()};
  if (!quick) {
    for (truth::Method& method : truth::parts_off()) {
      method.name = "64 lights, but " + method.name;
      methods.push_back(std::move(method));
    }
  }
  std::vector<TruthRow> rows{row_of("camera image alone",
                                    truth::mean_of(truth::errors_of_camera(kDirect)),
                                    truth::mean_of(truth::errors_of_camera(kFull)))};
  for (const truth::Method& method : methods) {
    say("against the truth: " + method.name);
    rows.push_back(row_of(method.name, truth::mean_of(truth::errors_of(method, kDirect)),
                          truth::mean_of(truth::errors_of(method, kFull))));
  }
  return rows;
}

}  // namespace amalgam::report
