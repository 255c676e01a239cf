#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace dbd {

/// A route with its drive as planned and again, more exactly and on ground drawn anew.
struct Judged {
  std::optional<std::size_t> index;  // into the pool and then the plan's candidates
  double score = std::numeric_limits<double>::infinity();
  double time = 0;
  bool reached = false;
  bool holds = false;
};

struct QueryResult {
  std::string site;
  double distance = 0;
  Eigen::Vector2d start, goal;  // map coordinates
  Judged chosen;
  Judged trusting;                  // what the plan would choose without draws
  Judged shortest, cheapest, best;  // of the pool
  double plan_time = 0;
  double kinematic_time = 0;  // layer and candidates, nothing driven
  std::optional<double> first_route_time;
};

/// One line per query.
void PrintQuery(int number, const QueryResult& result);

/// Shares, regrets and times over all queries.
void PrintSummary(const std::vector<QueryResult>& results);

}  // namespace dbd
