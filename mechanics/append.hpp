// Lists that are put together.
#pragma once

#include <iterator>
#include <vector>

namespace orbearing::mechanics {

/// Puts `more` behind the items of `all`.
template <class Item>
void append(std::vector<Item> more, std::vector<Item>& all) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace orbearing::mechanics
