#include "frame/still_frame.h"

#include <utility>

namespace amalgam::frame {

void StillView::begin(StillKey key) {
  seen_before_ = key_ == key;
  if (seen_before_) return;
  forget();
  key_ = std::move(key);
}

void StillView::forget() {
  *this = StillView();
}

}  // namespace amalgam::frame
