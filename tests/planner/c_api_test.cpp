#include <dbd/c/dbd.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/planner/plan_route.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

/// 80 m x 60 m of gentle waves in a file, north-west corner at 500000, 5200000.
class CApi : public testing::Test {
 protected:
  CApi() {
    TestRaster raster;
    raster.columns = 80;
    raster.rows = 60;
    raster.value = [](int column, int row) {
      return 0.3 * std::sin(0.2 * column) * std::cos(0.15 * row);
    };
    file_ = raster.Write(directory_.File("dem.tif"));
    files_.elevation = file_.c_str();
    EXPECT_EQ(dbd_terrain_load(&files_, &terrain_), DBD_OK) << dbd_last_error();
    EXPECT_EQ(dbd_vehicle_load("tomcar-tm27", &vehicle_), DBD_OK);
    EXPECT_EQ(dbd_service_create(2, 4, &service_), DBD_OK);
  }
  ~CApi() override {
    dbd_terrain_free(terrain_);
    dbd_vehicle_free(vehicle_);
    dbd_service_free(service_);
  }

  static dbd_request Request() {
    dbd_request request;
    dbd_request_init(&request);
    request.start[0] = 500015, request.start[1] = 5199970;
    request.goal[0] = 500055, request.goal[1] = 5199970;
    request.candidates = 3;
    return request;
  }

  dbd_job* Submit(const dbd_request& request) {
    dbd_job* job = nullptr;
    EXPECT_EQ(dbd_submit(service_, terrain_, vehicle_, &request, &job), DBD_OK);
    return job;
  }

  dbd_result ResultOf(const dbd_request& request) {
    dbd_job* job = Submit(request);
    EXPECT_EQ(dbd_job_wait(job, -1), DBD_OK);
    dbd_result result = {};
    EXPECT_EQ(dbd_job_result(job, &result), DBD_OK) << dbd_last_error();
    dbd_job_free(job);
    return result;
  }

  std::string FailureOf(const dbd_request& request) {
    dbd_job* job = Submit(request);
    dbd_result result = {};
    EXPECT_EQ(dbd_job_wait(job, -1), DBD_OK);
    EXPECT_EQ(dbd_job_result(job, &result), DBD_ERROR_INPUT);
    std::string reason = dbd_job_reason(job);
    EXPECT_EQ(reason, dbd_last_error());
    dbd_job_free(job);
    return reason;
  }

  TemporaryDirectory directory_;
  std::string file_;
  dbd_terrain_files files_ = {};
  dbd_terrain* terrain_ = nullptr;
  dbd_vehicle* vehicle_ = nullptr;
  dbd_service* service_ = nullptr;
};

TEST_F(CApi, AnswersAsPlanRouteDoes) {
  dbd_job* job = Submit(Request());
  ASSERT_EQ(dbd_job_wait(job, -1), DBD_OK);
  dbd_job_state state = DBD_JOB_QUEUED;
  EXPECT_EQ(dbd_job_get_state(job, &state), DBD_OK);
  EXPECT_EQ(state, DBD_JOB_DONE);
  dbd_result result;
  ASSERT_EQ(dbd_job_result(job, &result), DBD_OK);

  const auto terrain = LoadElevationOnly(file_);
  PlanRequest request;
  request.start = terrain->frame().FromSource({500015, 5199970});
  request.goal = terrain->frame().FromSource({500055, 5199970});
  PlanOptions options;
  options.sampling.candidates = 3;
  const Plan plan = PlanRoute(terrain, LoadVehicle("tomcar-tm27"), request, options);
  EXPECT_EQ(result.digest, plan.digest);
  EXPECT_EQ(result.status, DBD_PLAN_ROUTE);
  EXPECT_EQ(result.candidates, 3);
  EXPECT_TRUE(std::isnan(result.p_go));
  EXPECT_EQ(dbd_job_reason(job), plan.reason);

  const Rollout& route = plan.rollouts[static_cast<std::size_t>(*plan.chosen)];
  EXPECT_EQ(result.time, route.time);
  std::vector<dbd_point> points(result.points);
  ASSERT_EQ(dbd_job_route(job, points.data(), points.size()), DBD_OK);
  ASSERT_EQ(points.size(), route.trace.size());
  EXPECT_NEAR(points.front().x, 500015, 2);
  EXPECT_NEAR(points.back().x, 500055, 3);
  EXPECT_EQ(points.back().distance, route.trace.back().s);
  dbd_limit limit;
  std::size_t count = 0;
  ASSERT_EQ(dbd_job_limits(job, &limit, 1, &count), DBD_OK);
  EXPECT_EQ(count, route.margins.size());
  EXPECT_EQ(limit.name, route.margins[0].name);
  dbd_job_free(job);
}

TEST_F(CApi, JobsOutliveAllOtherHandles) {
  dbd_job* job = Submit(Request());
  dbd_terrain_free(terrain_);
  dbd_vehicle_free(vehicle_);
  EXPECT_EQ(dbd_job_wait(job, -1), DBD_OK);
  dbd_service_free(service_);
  terrain_ = nullptr, vehicle_ = nullptr, service_ = nullptr;
  dbd_result result;
  EXPECT_EQ(dbd_job_result(job, &result), DBD_OK);
  std::vector<dbd_point> points(result.points);
  EXPECT_EQ(dbd_job_route(job, points.data(), points.size()), DBD_OK);
  dbd_job_free(job);
}

TEST_F(CApi, TellsTheShareOfDrawsThatReachTheGoal) {
  dbd_request request = Request();
  request.draws = 3;
  const dbd_result result = ResultOf(request);
  EXPECT_GE(result.p_go, result.p_go_low);
  EXPECT_LE(result.p_go, result.p_go_high);
}

TEST_F(CApi, CancelsAndCallsBack) {
  std::atomic<int> ended = 0;
  dbd_request request = Request();
  request.candidates = 5000;
  request.user = &ended;
  request.on_end = [](void* user) { ++*static_cast<std::atomic<int>*>(user); };
  dbd_job* job = Submit(request);
  EXPECT_EQ(dbd_job_wait(job, 0.01), DBD_ERROR_NOT_ENDED);
  dbd_result result;
  EXPECT_EQ(dbd_job_result(job, &result), DBD_ERROR_NOT_ENDED);
  EXPECT_STREQ(dbd_job_reason(job), "");
  dbd_progress progress;
  EXPECT_EQ(dbd_job_get_progress(job, &progress), DBD_OK);
  EXPECT_EQ(dbd_job_cancel(job), DBD_OK);
  EXPECT_EQ(dbd_job_wait(job, 60), DBD_OK);
  ASSERT_EQ(dbd_job_result(job, &result), DBD_OK);
  EXPECT_EQ(result.status, DBD_PLAN_CANCELLED);
  EXPECT_EQ(result.has_route, 0);
  EXPECT_EQ(ended, 1);
  dbd_job_free(job);
}

TEST_F(CApi, AFullQueueIsAnErrorOrAWait) {
  dbd_request slow = Request();
  slow.candidates = 5000;
  std::vector<dbd_job*> jobs;
  dbd_error error = DBD_OK;
  while (error == DBD_OK && jobs.size() < 20) {
    dbd_job* job = nullptr;
    error = dbd_try_submit(service_, terrain_, vehicle_, &slow, &job);
    if (error == DBD_OK) jobs.push_back(job);
  }
  EXPECT_EQ(error, DBD_ERROR_FULL);
  EXPECT_THAT(dbd_last_error(), HasSubstr("the queue is full"));
  for (dbd_job* job : jobs) dbd_job_cancel(job);
  for (dbd_job* job : jobs) dbd_job_free(job);
}

TEST_F(CApi, SaysWhatIsWrong) {
  dbd_terrain* terrain = nullptr;
  dbd_terrain_files files = {};
  files.elevation = "/nonexistent.tif";
  EXPECT_EQ(dbd_terrain_load(&files, &terrain), DBD_ERROR_INPUT);
  EXPECT_THAT(dbd_last_error(), HasSubstr("/nonexistent.tif"));
  files = files_;
  files.material_table = "uscs";
  EXPECT_EQ(dbd_terrain_load(&files, &terrain), DBD_ERROR_INPUT);
  EXPECT_THAT(dbd_last_error(), HasSubstr("need each other"));
  files = files_;
  files.moisture = "soaked";
  EXPECT_EQ(dbd_terrain_load(&files, &terrain), DBD_ERROR_INPUT);
  EXPECT_THAT(dbd_last_error(), HasSubstr("\"soaked\", must be dry, moist or wet"));
  EXPECT_EQ(terrain, nullptr);
  dbd_vehicle* vehicle = nullptr;
  EXPECT_EQ(dbd_vehicle_load("moped", &vehicle), DBD_ERROR_INPUT);
  EXPECT_THAT(dbd_last_error(), HasSubstr("moped"));
  dbd_service* service = nullptr;
  EXPECT_EQ(dbd_service_create(-1, 4, &service), DBD_ERROR_INPUT);

  dbd_request request = Request();
  request.goal[0] = 1;
  EXPECT_THAT(FailureOf(request), HasSubstr("must lie inside the terrain"));
  request = Request();
  request.start[1] = std::nan("");
  EXPECT_THAT(FailureOf(request), HasSubstr("must lie inside the terrain"));
  request = Request();
  request.candidates = 0;
  EXPECT_THAT(FailureOf(request), HasSubstr("candidates"));
  request = Request();
  request.coordinates = 7;
  EXPECT_THAT(FailureOf(request), HasSubstr("coordinates"));
}

TEST_F(CApi, MayReverse) {
  // Nose away from the goal: backing is an option that changes what is sampled.
  dbd_request request = Request();
  request.start_yaw = 3.14159265;
  const dbd_result forward = ResultOf(request);
  request.reversing = 1;
  const dbd_result result = ResultOf(request);
  EXPECT_EQ(result.status, DBD_PLAN_ROUTE);
  EXPECT_NE(result.digest, forward.digest);
}

TEST_F(CApi, NullIsRefusedAndMayBeFreed) {
  dbd_request request = Request();
  dbd_job* job = nullptr;
  EXPECT_EQ(dbd_submit(service_, nullptr, vehicle_, &request, &job), DBD_ERROR_INPUT);
  EXPECT_STREQ(dbd_last_error(), "dbd_submit: an argument is NULL");
  EXPECT_EQ(dbd_terrain_load(nullptr, &terrain_), DBD_ERROR_INPUT);
  EXPECT_EQ(dbd_vehicle_load(nullptr, &vehicle_), DBD_ERROR_INPUT);
  EXPECT_EQ(dbd_job_wait(nullptr, 1), DBD_ERROR_INPUT);
  EXPECT_EQ(dbd_job_result(nullptr, nullptr), DBD_ERROR_INPUT);
  EXPECT_STREQ(dbd_job_reason(nullptr), "");
  dbd_request_init(nullptr);
  dbd_job_free(nullptr);
  dbd_terrain_free(nullptr);
  dbd_vehicle_free(nullptr);
  dbd_service_free(nullptr);
  EXPECT_STREQ(dbd_version(), "0.1.0");
}

TEST_F(CApi, EveryThreadHasAnErrorOfItsOwn) {
  EXPECT_EQ(dbd_job_cancel(nullptr), DBD_ERROR_INPUT);
  std::thread([] { EXPECT_STREQ(dbd_last_error(), ""); }).join();
  EXPECT_STREQ(dbd_last_error(), "dbd_job_cancel: an argument is NULL");
}

}  // namespace
}  // namespace dbd
