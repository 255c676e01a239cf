#include <cmath>

#include "c_handles.h"

namespace dbd {
namespace {

std::optional<double> YawOf(double yaw) {
  if (std::isnan(yaw)) return std::nullopt;
  return yaw;
}

Eigen::Vector2d PlaceOf(const Terrain& terrain, int coordinates, const double (&given)[2]) {
  const LocalFrame& frame = terrain.frame();
  const Eigen::Vector2d place(given[0], given[1]);
  if (coordinates == DBD_COORDINATES_MAP) return frame.FromSource(place);
  if (coordinates != DBD_COORDINATES_WGS84) throw InputError("coordinates: not one of the kinds");
  if (!frame.has_crs()) {
    throw InputError("coordinates: the elevation file has no coordinate system");
  }
  return frame.FromWgs84(place);
}

PlanOptions OptionsOf(const dbd_request& request) {
  PlanOptions options;
  options.sampling.candidates = request.candidates;
  options.sampling.reversing = request.reversing != 0;
  options.learning.rounds = request.rounds;
  options.seed = request.seed;
  options.max_speed = request.max_speed;
  options.deadline = request.deadline;
  options.uncertainty.draws = request.draws;
  options.uncertainty.min_success = request.min_success;
  return options;
}

PlanInputs InputsOf(const std::shared_ptr<const Terrain>& terrain,
                    const std::shared_ptr<const VehicleModel>& vehicle,
                    const dbd_request& request) {
  const auto place = [&](const double(&given)[2]) {
    return PlaceOf(*terrain, request.coordinates, given);
  };
  return {terrain,
          vehicle,
          {place(request.start), YawOf(request.start_yaw), place(request.goal),
           YawOf(request.goal_yaw)},
          OptionsOf(request)};
}

PlanJob JobOf(const dbd_terrain& terrain, const dbd_vehicle& vehicle, const dbd_request& request) {
  PlanJob job;
  job.prepare = [terrain = terrain.terrain, vehicle = vehicle.vehicle, request] {
    return InputsOf(terrain, vehicle, request);
  };
  job.priority = request.priority;
  if (request.on_end != nullptr) {
    job.on_end = [request](const JobResult&) { request.on_end(request.user); };
  }
  return job;
}

}  // namespace
}  // namespace dbd

dbd_error dbd_service_create(int threads, size_t queue_limit, dbd_service** service) {
  return dbd::Guarded([&] {
    dbd::RequireAll("dbd_service_create", service);
    if (threads < 0 || threads > 1024) {
      throw dbd::InputError("dbd_service_create: threads must be between 0 and 1024");
    }
    *service =
        new dbd_service{dbd::PlanningService({.threads = threads, .queue_limit = queue_limit})};
    return DBD_OK;
  });
}

void dbd_service_free(dbd_service* service) { delete service; }

void dbd_request_init(dbd_request* request) {
  if (request == nullptr) return;
  const dbd::PlanOptions options;
  *request = {};
  request->start_yaw = request->goal_yaw = std::nan("");
  request->candidates = options.sampling.candidates;
  request->rounds = options.learning.rounds;
  request->seed = options.seed;
  request->max_speed = options.max_speed;
  request->deadline = options.deadline;
  request->draws = options.uncertainty.draws;
}

dbd_error dbd_submit(dbd_service* service, const dbd_terrain* terrain, const dbd_vehicle* vehicle,
                     const dbd_request* request, dbd_job** job) {
  return dbd::Guarded([&] {
    dbd::RequireAll("dbd_submit", service, terrain, vehicle, request, job);
    *job = new dbd_job{service->service.Submit(dbd::JobOf(*terrain, *vehicle, *request))};
    return DBD_OK;
  });
}

dbd_error dbd_try_submit(dbd_service* service, const dbd_terrain* terrain,
                         const dbd_vehicle* vehicle, const dbd_request* request, dbd_job** job) {
  return dbd::Guarded([&] {
    dbd::RequireAll("dbd_try_submit", service, terrain, vehicle, request, job);
    const auto handle = service->service.TrySubmit(dbd::JobOf(*terrain, *vehicle, *request));
    if (!handle) return dbd::Failed(DBD_ERROR_FULL, "dbd_try_submit: the queue is full");
    *job = new dbd_job{*handle};
    return DBD_OK;
  });
}
