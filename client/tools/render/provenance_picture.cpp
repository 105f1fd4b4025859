#include "client/tools/render/provenance_picture.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "common/whole_file.h"

namespace amalgam::tools {
namespace {

struct SourceColor {
  cv::Vec3f bgr;
  const char* meaning;
};

// By core::LightSource.
const std::array<SourceColor, core::kLightSources> kSources{{
    {{225, 225, 225}, "drawn by the rasteriser"},
    {{40, 140, 240}, "virtual surface, traced"},
    {{75, 160, 60}, "camera image, looked up"},
    {{60, 50, 210}, "real surface, as modelled"},
    {{215, 120, 60}, "environment"},
    {{220, 80, 230}, "environment, ray cut off"},
}};

cv::Mat paint(const core::ProvenanceImage& provenance) {
  const cv::Vec3f white(255, 255, 255);
  cv::Mat picture(provenance.height(), provenance.width(), CV_8UC3);
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      cv::Vec3f color(0, 0, 0);
      float sum = 0.0f;
      for (std::size_t k = 0; k < core::kLightSources; ++k) {
        const float share = provenance.at(x, y)[k];
        color += share * kSources[k].bgr;
        sum += share;
      }
      // Less than 1 where colored glass absorbed the rest, or only a part of the pixel is covered.
      if (sum < 1.0f) color += (1.0f - sum) * white;
      picture.at<cv::Vec3b>(y, x) = color;
    }
  }
  return picture;
}

// Two columns, in letters that suit the width.
cv::Mat legend(int width) {
  const double scale = std::max(0.3, width / 1300.0);
  const int line = static_cast<int>(40 * scale), half = (static_cast<int>(kSources.size()) + 1) / 2;
  cv::Mat picture(line * (half + 1), width, CV_8UC3, cv::Scalar(255, 255, 255));
  for (int k = 0; k < static_cast<int>(kSources.size()); ++k) {
    const SourceColor& source = kSources[static_cast<std::size_t>(k)];
    const int x = line / 2 + k / half * width / 2, y = line / 2 + k % half * line;
    cv::rectangle(picture, {x, y, line - 4, line - 4}, cv::Scalar(source.bgr), cv::FILLED);
    cv::putText(picture, source.meaning, {x + line + 4, y + line - 10}, cv::FONT_HERSHEY_SIMPLEX,
                scale, cv::Scalar(0, 0, 0), 1, cv::LINE_AA);
  }
  return picture;
}

}  // namespace

void write_provenance_picture(const core::ProvenanceImage& provenance,
                              const std::filesystem::path& file) {
  cv::Mat picture;
  cv::vconcat(paint(provenance), legend(provenance.width()), picture);
  common::write_whole_file(file, [&](const std::filesystem::path& path) {
    if (!cv::imwrite(path.string(), picture)) {
      throw std::runtime_error(file.string() + ": cannot be written");
    }
  });
}

}  // namespace amalgam::tools
