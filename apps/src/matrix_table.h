#pragma once

#include <dbd/planner/plan_types.h>
#include <dbd/terrain/local_frame.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "matrix_places.h"
#include "plan_command.h"

namespace dbd {

/// One combination of the axes of a matrix: indices.
struct MatrixPair {
  std::size_t vehicle = 0;
  std::size_t soil = 0;
  std::size_t start = 0;
  std::size_t goal = 0;
};

/// What a matrix spans.
struct MatrixAxes {
  std::vector<std::string> vehicles;
  std::vector<std::string> soils;  ///< names; one that is empty when there are no states
  std::vector<MatrixPlace> starts;
  std::vector<MatrixPlace> goals;

  std::size_t size() const { return vehicles.size() * soils.size() * starts.size() * goals.size(); }
  /// The last axis first.
  MatrixPair Pair(std::size_t index) const;
};

/// What became of one pair.
struct MatrixAnswer {
  std::string status = "cancelled";  ///< that of a plan, "error", or "same_place"
  std::string reason = "stopped before there was an answer";
  std::optional<Rollout> route;  ///< with its trace only where routes are written
  std::optional<SuccessEstimate> success;
  std::optional<std::uint64_t> digest;
};

/// A finished matrix; `answers` in the order of `MatrixAxes::Pair`. A view.
struct MatrixRecord {
  const MatrixAxes& axes;
  const std::vector<MatrixAnswer>& answers;
  const PlanArguments& arguments;
  const LocalFrame& frame;
};

/// One line per pair, with a header.
std::string MatrixCsv(const MatrixRecord& record);

/// The content of matrix.json (schema dbd.matrix/1).
std::string MatrixJson(const MatrixRecord& record);

/// All routes that were found. The frame must have a coordinate system.
std::string MatrixRoutes(const MatrixRecord& record);

}  // namespace dbd
