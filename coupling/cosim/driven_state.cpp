#include "coupling/cosim/driven_state.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace orbearing::cosim {

namespace {
constexpr double kVersion = 2.0;
constexpr std::ptrdiff_t kHead = 4;  // version and kind
}  // namespace

void write(const StateKind& kind, DrivenState& state, SavedState& into) {
  into = {kVersion, kind[0], kind[1], kind[2]};
  state.each([&](const double* first, long size) { into.insert(into.end(), first, first + size); });
}

void read(const SavedState& from, const StateKind& kind, DrivenState& state) {
  SavedState own;
  write(kind, state, own);
  if (from.size() != own.size() || !std::equal(own.begin(), own.begin() + kHead, from.begin())) {
    std::ostringstream text;
    text << "driven bearing: found a saved state of " << from.size() << " numbers";
    if (!from.empty()) text << " and version " << from.front();
    text << "; required: " << own.size() << " numbers of version " << kVersion << ", of a bearing with "
         << kind[0] << " rollers and " << kind[1] << " places";
    throw std::invalid_argument(text.str());
  }
  auto at = from.begin() + kHead;
  state.each([&](double* first, long size) {
    std::copy_n(at, size, first);
    at += size;
  });
}

}  // namespace orbearing::cosim
