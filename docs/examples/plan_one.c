/* Plans one route through the C interface: plan_one_c ELEVATION X0 Y0 X1 Y1, in the coordinates of
 * the elevation file. */

#include <dbd/c/dbd.h>
#include <stdio.h>
#include <stdlib.h>

static int fail(void) {
  fprintf(stderr, "%s\n", dbd_last_error());
  return 2;
}

static int print_route(const dbd_job* job, const dbd_result* result) {
  dbd_point* points = calloc(result->points, sizeof *points);
  dbd_limit limits[16];
  size_t count = 0, i;
  if (points == NULL) return 1;
  if (dbd_job_route(job, points, result->points) != DBD_OK) return fail();
  if (dbd_job_limits(job, limits, 16, &count) != DBD_OK) return fail();
  printf("%.0f m in %.0f s, %zu points, the last at %.1f, %.1f\n", result->length, result->time,
         result->points, points[result->points - 1].x, points[result->points - 1].y);
  for (i = 0; i < count && i < 16; ++i) {
    printf("  %-14s %3.0f %% left\n", limits[i].name, 100 * limits[i].margin);
  }
  free(points);
  return 0;
}

static int print_answer(const dbd_job* job) {
  dbd_result result;
  dbd_progress progress;
  while (dbd_job_wait(job, 0.2) == DBD_ERROR_NOT_ENDED) {
    if (dbd_job_get_progress(job, &progress) != DBD_OK) return fail();
    printf("%s %d of %d\n", progress.stage[0] ? progress.stage : "starting", progress.done,
           progress.total);
  }
  if (dbd_job_result(job, &result) != DBD_OK) return fail();
  if (result.has_route) return print_route(job, &result);
  printf("no safe route: %s\n", dbd_job_reason(job));
  return 3;
}

int main(int argc, char** argv) {
  dbd_terrain_files files = {0};
  dbd_terrain* terrain = NULL;
  dbd_vehicle* vehicle = NULL;
  dbd_service* service = NULL;
  dbd_job* job = NULL;
  dbd_request request;
  int code;
  if (argc != 6) return 2;
  files.elevation = argv[1];
  dbd_request_init(&request);
  request.start[0] = atof(argv[2]);
  request.start[1] = atof(argv[3]);
  request.goal[0] = atof(argv[4]);
  request.goal[1] = atof(argv[5]);
  request.candidates = 8;
  code = dbd_terrain_load(&files, &terrain) != DBD_OK ||
                 dbd_vehicle_load("tomcar-tm27", &vehicle) != DBD_OK ||
                 dbd_service_create(0, 100, &service) != DBD_OK ||
                 dbd_submit(service, terrain, vehicle, &request, &job) != DBD_OK
             ? fail()
             : print_answer(job);
  dbd_job_free(job);
  dbd_service_free(service);
  dbd_vehicle_free(vehicle);
  dbd_terrain_free(terrain);
  return code;
}
