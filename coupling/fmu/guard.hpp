// The boundary to C: nothing is thrown over it, every refusal is logged.
#pragma once

#include <exception>
#include <new>

#include "coupling/fmu/instance.hpp"

namespace orbearing::fmu {

/// Carries `body` out on `component`, an Instance, and returns how that went.
template <class Body>
Status guarded(void* component, const char* function, Body&& body) noexcept {
  if (component == nullptr) return Status::error;  // no receiver of a message
  Instance& instance = *static_cast<Instance*>(component);
  Status status = Status::error;
  try {
    body(instance);
    return Status::ok;
  } catch (const Refused& refused) {
    status = refused.status;
    instance.log(status, function, refused.what());
  } catch (const std::bad_alloc&) {
    instance.log(status, function, "found no memory");
  } catch (const std::exception& failure) {
    instance.log(status, function, failure.what());
  } catch (...) {
    instance.log(status, function, "failed for a reason that is not known");
  }
  return status;
}

/// A new instance, or null with the reason in `log`. `wrong`: what is wrong with the call, or null.
Instance* new_instance(const char* function, const char* wrong, const char* token, const char* resources,
                       Log log, bool logging) noexcept;

/// Throws Refused for NULL, where a call writes `what`.
void require_position(const void* pointer, const char* what);

/// `list` of so many categories as strings. Throws Refused for NULL.
std::vector<std::string> categories_of(std::size_t number, const char* const* list);

}  // namespace orbearing::fmu
