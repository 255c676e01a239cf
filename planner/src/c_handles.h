#pragma once

#include <dbd/c/dbd.h>
#include <dbd/core/error.h>
#include <dbd/planner/planning_service.h>

#include <memory>
#include <string>

// What the C interface's handles are, and how its functions keep exceptions inside.

struct dbd_terrain {
  std::shared_ptr<const dbd::Terrain> terrain;
};

struct dbd_vehicle {
  std::shared_ptr<const dbd::VehicleModel> vehicle;
};

struct dbd_service {
  dbd::PlanningService service;
};

struct dbd_job {
  dbd::PlanningService::Handle handle;
};

namespace dbd {

/// Keeps the text for `dbd_last_error` of this thread; returns the code.
dbd_error Failed(dbd_error code, const char* text) noexcept;

/// Runs `body`, which returns an error code, and turns what it throws into one.
template <typename Body>
dbd_error Guarded(Body&& body) noexcept {
  try {
    return body();
  } catch (const InputError& error) {
    return Failed(DBD_ERROR_INPUT, error.what());
  } catch (const std::exception& error) {
    return Failed(DBD_ERROR_INTERNAL, error.what());
  } catch (...) {
    return Failed(DBD_ERROR_INTERNAL, "an exception that is no std::exception");
  }
}

/// Throws InputError when one of the pointers is null; `function` is named.
template <typename... Pointers>
void RequireAll(const char* function, const Pointers*... pointers) {
  if (((pointers == nullptr) || ...)) {
    throw InputError(std::string(function) + ": an argument is NULL");
  }
}

}  // namespace dbd
