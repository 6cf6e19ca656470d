#include "apps/view/control/row_filter.h"

#include "apps/view/control/panel_text.h"

namespace soms::view {

std::size_t RowFilter::update(const EventList& list, const std::string& wanted) {
  if (wanted != wanted_ || list.edition != edition_) {
    wanted_ = wanted;
    edition_ = list.edition;
    rows_.clear();
    looked_at_ = 0;
  }
  const std::size_t before = looked_at_;
  for (; looked_at_ < list.rows.size(); ++looked_at_) {
    if (has_words(list.rows[looked_at_].title, wanted_)) {
      rows_.push_back(looked_at_);
    }
  }
  return looked_at_ - before;
}

}  // namespace soms::view
