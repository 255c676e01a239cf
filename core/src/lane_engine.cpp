#include "lane_engine.h"

#include "lane_engine_includes.h"

namespace dbd {
namespace {

#ifdef DBD_WIDE_LANES
bool HasAvx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
bool HasAvx512() {
  return HasAvx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
}
#else
bool HasAvx2() { return false; }
bool HasAvx512() { return false; }
#endif

LaneKind Widest(bool doubles) {
  if (HasAvx512()) return doubles ? LaneKind::kDouble8 : LaneKind::kFloat16;
  if (HasAvx2()) return doubles ? LaneKind::kDouble4 : LaneKind::kFloat8;
  return doubles ? LaneKind::kDouble2 : LaneKind::kFloat4Plain;
}

}  // namespace

LaneEngine::~LaneEngine() = default;

bool LaneKindAvailable(LaneKind kind) {
  if (kind == LaneKind::kFloat16 || kind == LaneKind::kDouble8) return HasAvx512();
  if (kind == LaneKind::kFloat8 || kind == LaneKind::kFloat4 || kind == LaneKind::kDouble4) {
    return HasAvx2();
  }
  return true;
}

std::string LaneKindName(LaneKind kind) {
  switch (kind) {
    case LaneKind::kFloat:
      return LaneKindName(Widest(false));
    case LaneKind::kDouble:
      return LaneKindName(Widest(true));
    case LaneKind::kFloat16:
      return "float x 16";
    case LaneKind::kFloat8:
      return "float x 8";
    case LaneKind::kFloat4:
      return "float x 4";
    case LaneKind::kFloat4Plain:
      return "float x 4, plain";
    case LaneKind::kDouble8:
      return "double x 8";
    case LaneKind::kDouble4:
      return "double x 4";
    case LaneKind::kDouble2:
      return "double x 2";
  }
  return "";
}

std::unique_ptr<LaneEngine> MakeLaneEngine(LaneKind kind, const VehicleModel& vehicle,
                                           const Ground& ground) {
  if (!LaneKindAvailable(kind)) return nullptr;
  switch (kind) {
    case LaneKind::kFloat:
    case LaneKind::kDouble:
      return MakeLaneEngine(Widest(kind == LaneKind::kDouble), vehicle, ground);
    case LaneKind::kFloat16:
    case LaneKind::kDouble8:
      return MakeAvx512Lanes(kind, vehicle, ground);
    case LaneKind::kFloat8:
    case LaneKind::kFloat4:
    case LaneKind::kDouble4:
      return MakeAvx2Lanes(kind, vehicle, ground);
    case LaneKind::kFloat4Plain:
    case LaneKind::kDouble2:
      return MakePortableLanes(kind, vehicle, ground);
  }
  return nullptr;
}

}  // namespace dbd
