// States of an instance: kept, gone back to, written as bytes.
#include <algorithm>

#include "coupling/fmu/instance.hpp"

namespace orbearing::fmu {

namespace {

auto is_at(const InstanceState* state) {
  return [state](const InstanceState& kept) { return &kept == state; };
}

}  // namespace

void Instance::require_known(const InstanceState* state) const {
  if (state == nullptr || std::none_of(kept_.begin(), kept_.end(), is_at(state)))
    throw Refused("state: found none of this instance; required: one that it gave and that was not freed");
}

InstanceState Instance::present() const {
  InstanceState state = state_;
  if (state.computed) participant_->save(state.participant);
  return state;
}

InstanceState* Instance::place_state(InstanceState state, InstanceState* again) {
  if (again == nullptr) return &kept_.emplace_back(std::move(state));
  require_known(again);
  *again = std::move(state);
  return again;
}

InstanceState* Instance::keep_state(InstanceState* again) {
  return place_state(present(), again);
}

void Instance::go_to_state(const InstanceState* state) {
  require_known(state);
  if (participant_ && state->parameters != state_.parameters) participant_.reset();
  state_ = *state;
  state_.participant.clear();
  outputs_.reset();
  if (state->computed) participant().restore(state->participant);  // it fits: it was saved or tried before
}

void Instance::free_state(const InstanceState* state) {
  if (state == nullptr) return;
  require_known(state);
  kept_.remove_if(is_at(state));
}

std::size_t Instance::state_size(const InstanceState* state) const {
  require_known(state);
  return byte_number(*state);
}

void Instance::serialize(const InstanceState* state, char* bytes, std::size_t size) const {
  require_known(state);
  const std::string all = bytes_of(*state, hash_);
  if (bytes == nullptr || size < all.size())
    throw Refused("serialised state: found room for " + std::to_string(bytes == nullptr ? 0 : size) +
                  " bytes; required: " + std::to_string(all.size()));
  std::copy(all.begin(), all.end(), bytes);
}

InstanceState* Instance::deserialize(const char* bytes, std::size_t size, InstanceState* again) {
  if (bytes == nullptr) throw Refused("serialised state: found NULL; required: bytes");
  InstanceState state =
      state_from(bytes, size, hash_, {facts_.shown.parameters.size(), facts_.inputs.size()});
  if (state.computed)
    make_participant(numbers_, state.parameters)->restore(state.participant);  // a state that fits
  return place_state(std::move(state), again);
}

}  // namespace orbearing::fmu
