/* dbd for C, and for languages that bind to C: plans routes with one service.
 *
 *   dbd_terrain_load, dbd_vehicle_load -> dbd_service_create -> dbd_submit -> dbd_job_wait
 *   -> dbd_job_result, dbd_job_route
 *
 * Handles are opaque. Each is freed once, by its own function, in any order: a job keeps what it
 * needs alive. Freeing NULL does nothing. Functions return DBD_OK or an error code, write their
 * result through the last pointer, and leave it alone when they fail. No exception leaves them.
 *
 * Any function may be called from any thread, also with a handle that other threads use, as long as
 * nobody frees it meanwhile. SI units; angles in radians; text is UTF-8 and ends with a zero. */
#ifndef DBD_C_DBD_H_
#define DBD_C_DBD_H_

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum dbd_error {
  DBD_OK = 0,
  DBD_ERROR_INTERNAL = 1, /* a mistake of dbd's, or no memory */
  DBD_ERROR_INPUT = 2,    /* an input broke a rule; dbd_last_error says which */
  DBD_ERROR_FULL = 3,     /* the queue has no place */
  DBD_ERROR_NOT_ENDED = 4 /* the job still waits or runs */
} dbd_error;

/* What went wrong in the last function of this thread that failed: one line, "" when none has.
 * Valid until the next call of this thread. */
const char* dbd_last_error(void);

/* Of the library: "0.1.0". */
const char* dbd_version(void);

/* Terrain and vehicle: immutable, shared by any number of jobs. */

typedef struct dbd_terrain dbd_terrain;
typedef struct dbd_vehicle dbd_vehicle;

/* Files of a terrain; NULL where there is none. */
typedef struct dbd_terrain_files {
  const char* elevation;      /* required: a raster, a TIN, points or an OctoMap */
  const char* crs;            /* of the elevation, instead of what its file states */
  const char* materials;      /* class raster or polygons */
  const char* material_table; /* a built-in table or a file; with materials */
  const char* moisture;       /* of the soils: "dry", "moist" or "wet" */
  const char* obstacles;      /* OctoMap */
  const char* surface_model;  /* raster with what stands on the ground */
} dbd_terrain_files;

dbd_error dbd_terrain_load(const dbd_terrain_files* files, dbd_terrain** terrain);
void dbd_terrain_free(dbd_terrain* terrain);

/* A built-in vehicle by name, or a file. */
dbd_error dbd_vehicle_load(const char* name_or_file, dbd_vehicle** vehicle);
void dbd_vehicle_free(dbd_vehicle* vehicle);

/* The service. */

typedef struct dbd_service dbd_service;

/* `threads`: of all jobs together, 0 = all processors. `queue_limit`: jobs that wait, at most. */
dbd_error dbd_service_create(int threads, size_t queue_limit, dbd_service** service);

/* Cancels every job and waits for the running ones to notice. Their handles stay valid. */
void dbd_service_free(dbd_service* service);

/* Requests. */

typedef enum dbd_coordinates {
  DBD_COORDINATES_MAP = 0,  /* those of the elevation file */
  DBD_COORDINATES_WGS84 = 1 /* longitude, latitude [degrees] */
} dbd_coordinates;

typedef struct dbd_request {
  double start[2];
  double goal[2];
  int coordinates;  /* dbd_coordinates */
  double start_yaw; /* 0 = east, counter-clockwise; NAN: any */
  double goal_yaw;
  int candidates; /* routes to drive */
  int rounds;     /* of driving and learning */
  int reversing;  /* not 0: routes may change between forward and reverse */
  uint64_t seed;
  double max_speed;   /* [m/s] */
  double deadline;    /* [s], then the best so far; INFINITY: none */
  int draws;          /* of what is uncertain of the terrain; 1: as it is given */
  double min_success; /* share of the draws on which a route must reach the goal */
  int priority;       /* higher first */
  /* Called once when the job has ended, whatever its end, from a thread of the service or the one
   * that cancels it; must not wait for a job. NULL: not called. */
  void (*on_end)(void* user);
  void* user;
} dbd_request;

/* Sets every field to its default; start and goal to 0. */
void dbd_request_init(dbd_request* request);

/* Jobs. */

typedef struct dbd_job dbd_job;

/* Waits while the queue is full. What is wrong with the request is found out when the job runs. */
dbd_error dbd_submit(dbd_service* service, const dbd_terrain* terrain, const dbd_vehicle* vehicle,
                     const dbd_request* request, dbd_job** job);
/* DBD_ERROR_FULL instead of waiting. */
dbd_error dbd_try_submit(dbd_service* service, const dbd_terrain* terrain,
                         const dbd_vehicle* vehicle, const dbd_request* request, dbd_job** job);
/* Does not cancel it. */
void dbd_job_free(dbd_job* job);

typedef enum dbd_job_state {
  DBD_JOB_QUEUED = 0,
  DBD_JOB_RUNNING = 1,
  DBD_JOB_DONE = 2,
  DBD_JOB_FAILED = 3,
  DBD_JOB_CANCELLED = 4
} dbd_job_state;

dbd_error dbd_job_get_state(const dbd_job* job, dbd_job_state* state);

typedef struct dbd_progress {
  char stage[32]; /* "sample", "drive", "learn", "draws"; "" before it runs */
  int done;
  int total;
} dbd_progress;

dbd_error dbd_job_get_progress(const dbd_job* job, dbd_progress* progress);

/* Waits for the end, at most `seconds` (below zero: as long as it takes), else
 * DBD_ERROR_NOT_ENDED. */
dbd_error dbd_job_wait(const dbd_job* job, double seconds);
dbd_error dbd_job_cancel(dbd_job* job);

/* Results. */

typedef enum dbd_plan_status {
  DBD_PLAN_ROUTE = 0,
  DBD_PLAN_NO_GO = 1,    /* no safe route: see dbd_job_reason */
  DBD_PLAN_DEADLINE = 2, /* the best so far, if there is one */
  DBD_PLAN_CANCELLED = 3
} dbd_plan_status;

typedef struct dbd_result {
  dbd_plan_status status;
  int has_route;   /* 0: the numbers of the route are 0 */
  double time;     /* [s] */
  double length;   /* driven [m] */
  double energy;   /* at the driven wheels [J] */
  size_t points;   /* of the driven route */
  int candidates;  /* that were driven */
  int reached;     /* of these, the goal */
  double p_go;     /* (reached + 1) / (draws + 2); NAN without draws */
  double p_go_low; /* its 95 % interval */
  double p_go_high;
  uint64_t digest; /* of everything that must be reproducible */
} dbd_result;

/* DBD_ERROR_NOT_ENDED before the end; for a job that failed its error, DBD_ERROR_INPUT. */
dbd_error dbd_job_result(const dbd_job* job, dbd_result* result);

/* Why this is the answer: one sentence, "" before the end. Valid as long as the handle. */
const char* dbd_job_reason(const dbd_job* job);

typedef struct dbd_point {
  double x; /* in the elevation file's own coordinates */
  double y;
  double z; /* height of the ground [m] */
  double time;
  double distance;
  double speed;
  double yaw;
  double pitch; /* positive nose down */
  double roll;  /* positive left side up */
} dbd_point;

/* Copies the first `capacity` points of the driven route; dbd_result.points says how many there
 * are. */
dbd_error dbd_job_route(const dbd_job* job, dbd_point* points, size_t capacity);

typedef struct dbd_limit {
  char name[32]; /* "roll", "clearance", ... */
  double limit;
  double worst;    /* met on the route */
  double margin;   /* share of the limit that is left */
  double distance; /* where [m] */
} dbd_limit;

/* Copies the first `capacity` limits of the route's certificate and sets `count` to how many there
 * are. */
dbd_error dbd_job_limits(const dbd_job* job, dbd_limit* limits, size_t capacity, size_t* count);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif /* DBD_C_DBD_H_ */
