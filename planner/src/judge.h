#pragma once

#include <dbd/core/vehicle_model.h>

#include <optional>

#include "observation.h"

namespace dbd {

struct Verdict {
  Outcome outcome;
  std::string reason;
};

/// Watches one drive against the vehicle's limits and says when and why it is over. Also keeps
/// the worst value of every limit and where it was met: the certificate.
class Judge {
 public:
  Judge(const VehicleModel& vehicle, bool stop_at_violation);

  /// `progress`: arc length reached on the path [m]; `wanted_speed`: what the driver aims for.
  std::optional<Verdict> Look(const Observation& observation, double progress, double wanted_speed);

  /// Whether a look at this time may find that there has been no progress for too long.
  bool MayFindStuck(double time) const;

  std::vector<LimitMargin> Margins() const { return margins_; }

 private:
  std::optional<Verdict> LookAtLimits(const TraceSample& sample);
  std::optional<Verdict> LookForProgress(const TraceSample& sample, double progress,
                                         double wanted_speed);

  const VehicleModel& vehicle_;
  bool stop_at_violation_;
  std::vector<LimitMargin> margins_;
  double steady_load_transfer_ = 0;  // low-passed
  double last_time_ = 0;
  double progress_mark_ = 0;
  double progress_time_ = 0;
};

}  // namespace dbd
