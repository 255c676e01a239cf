#pragma once

#include <dbd/planner/plan_types.h>
#include <dbd/terrain/local_frame.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace dbd {

/// The document with a line break at the end. Text that is not UTF-8 (file names can be anything)
/// is repaired.
std::string JsonText(const nlohmann::ordered_json& document);

/// A value cut to what is meant, so that files are short and readable.
double Rounded(double value, int decimals);

/// [longitude, latitude] in degrees, cut to about a millimetre.
nlohmann::ordered_json LonLatJson(const LocalFrame& frame, const Eigen::Vector2d& local);

/// {"map": [x, y], "lon_lat": [longitude, latitude]}, the latter where the frame has a system.
nlohmann::ordered_json PlaceJson(const LocalFrame& frame, const Eigen::Vector2d& local);

/// The same with "height" [m].
nlohmann::ordered_json PlaceJson(const LocalFrame& frame, const Eigen::Vector3d& local);

/// Totals of a drive: outcome, reason, place, length, time, energy, progress. SI.
nlohmann::ordered_json RolloutJson(const Rollout& rollout, const LocalFrame& frame);

/// Totals of the chosen route; null when there is none. SI.
nlohmann::ordered_json RouteJson(const Plan& plan);

/// The certificate: limit margins, the name of the binding one, and the per-metre table as
/// columns.
nlohmann::ordered_json CertificateJson(const Rollout& rollout, const LocalFrame& frame);

/// How a candidate did on drawn terrains.
nlohmann::ordered_json SuccessJson(const SuccessEstimate& estimate, const LocalFrame& frame);

nlohmann::ordered_json VersionsJson();

}  // namespace dbd
