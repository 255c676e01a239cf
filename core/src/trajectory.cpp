#include <dbd/core/error.h>
#include <dbd/core/trajectory.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>

namespace dbd {
namespace {

constexpr std::size_t kColumns = 19;
constexpr double kCompareFrom = 2.0;  // [s] both stand until then
constexpr double kLeastRange = 1e-6;  // [m], [rad], [m/s] or [N]

using RowValues = std::array<double, kColumns>;

RowValues ToValues(const TrajectoryRow& row) {
  RowValues v{row.t, row.x_cg, row.z_cg, row.z_ref, row.pitch, row.roll, row.vx};
  for (std::size_t i = 0; i < 4; ++i) {
    v[7 + i] = row.spring_force[i];
    v[11 + i] = row.wheel_height[i];
    v[15 + i] = row.tire_force[i];
  }
  return v;
}

TrajectoryRow FromValues(const RowValues& v) {
  TrajectoryRow row{v[0], v[1], v[2], v[3], v[4], v[5], v[6], {}, {}, {}};
  for (std::size_t i = 0; i < 4; ++i) {
    row.spring_force[i] = v[7 + i];
    row.wheel_height[i] = v[11 + i];
    row.tire_force[i] = v[15 + i];
  }
  return row;
}

RowValues ParseRow(const std::string& line, const std::string& place) {
  RowValues values{};
  const char* at = line.data();
  const char* end = line.data() + line.size();
  for (std::size_t i = 0; i < kColumns; ++i) {
    const auto [next, error] = std::from_chars(at, end, values[i]);
    const bool last = i + 1 == kColumns;
    const bool ends = last ? next == end || *next == '\r' : next != end && *next == ',';
    if (error != std::errc() || !ends || !std::isfinite(values[i])) {
      throw InputError(place + ": must have " + std::to_string(kColumns) + " numbers");
    }
    at = next + 1;
  }
  return values;
}

/// Wheels of the foremost and of the rearmost axle, in the order of the file.
std::array<int, 4> WheelOrder(const VehicleModel& vehicle) {
  const auto [rear, front] =
      std::minmax_element(vehicle.axles.begin(), vehicle.axles.end(),
                          [](const AxleModel& a, const AxleModel& b) { return a.x < b.x; });
  return {front->left, front->right, rear->left, rear->right};
}

/// The spring that acts on a wheel's body nearest to the wheel, -1 when there is none.
int SpringAt(const VehicleModel& vehicle, int wheel_index) {
  const WheelModel& wheel = vehicle.wheels[wheel_index];
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i) {
    const SpringModel& spring = vehicle.springs[i];
    const double distance = std::abs(spring.p_B.y() - wheel.p_BH.y());
    if (spring.body_b != wheel.body || distance >= least) continue;
    least = distance;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

RowValues Interpolate(const std::vector<TrajectoryRow>& rows, double t) {
  const auto after = std::lower_bound(rows.begin(), rows.end(), t - 1e-9,
                                      [](const auto& row, double time) { return row.t < time; });
  if (after == rows.begin() || after == rows.end() || after->t < t + 1e-9) {
    return ToValues(after == rows.end() ? rows.back() : *after);
  }
  const RowValues a = ToValues(*(after - 1)), b = ToValues(*after);
  const double share = (t - a[0]) / (b[0] - a[0]);
  RowValues v;
  for (std::size_t i = 0; i < kColumns; ++i) v[i] = a[i] + share * (b[i] - a[i]);
  return v;
}

/// A signal without its value at rest.
struct Signal {
  double rest = 0;
  std::vector<double> values;
};

/// Largest magnitude, of the values plus `offset`.
double Peak(const std::vector<double>& values, double offset) {
  double peak = 0;
  for (const double value : values) peak = std::max(peak, std::abs(value + offset));
  return peak;
}

double RelativeError(double ours, double theirs) { return std::abs(ours - theirs) / theirs; }

SignalAgreement Agreement(const std::string& name, const Signal& ours, const Signal& theirs) {
  const auto n = static_cast<double>(theirs.values.size());
  double mean = 0, residual = 0, spread = 0;
  for (const double value : theirs.values) mean += value / n;
  for (std::size_t i = 0; i < theirs.values.size(); ++i) {
    residual += std::pow(ours.values[i] - theirs.values[i], 2);
    spread += std::pow(theirs.values[i] - mean, 2);
  }
  const auto [low, high] = std::minmax_element(theirs.values.begin(), theirs.values.end());
  return {name, 1 - residual / spread, std::sqrt(residual / n) / (*high - *low),
          RelativeError(Peak(ours.values, 0), Peak(theirs.values, 0)),
          RelativeError(Peak(ours.values, ours.rest), Peak(theirs.values, theirs.rest))};
}

}  // namespace

std::vector<std::string> TrajectoryColumns() {
  return {"t",     "x_cg",  "z_cg",  "z_ref", "pitch", "roll",  "vx",    "Fs_fl", "Fs_fr", "Fs_rl",
          "Fs_rr", "zw_fl", "zw_fr", "zw_rl", "zw_rr", "Ft_fl", "Ft_fr", "Ft_rl", "Ft_rr"};
}

TrajectoryRow ChassisRow(double time, const ChassisView& chassis, const VehicleModel& vehicle) {
  const Eigen::Vector3d p_WR = chassis.p_WB - chassis.q_WB * vehicle.bodies[0].p_RB;
  TrajectoryRow row;
  row.t = time;
  row.x_cg = chassis.p_WB.x();
  row.z_cg = chassis.p_WB.z();
  row.z_ref = p_WR.z();
  row.pitch = chassis.pitch;
  row.roll = chassis.roll;
  row.vx = chassis.v_WB.x();
  return row;
}

TrajectoryRow ObserveRow(const Simulation& simulation, const VehicleModel& vehicle) {
  const std::array<int, 4> order = WheelOrder(vehicle);
  TrajectoryRow row = ChassisRow(simulation.time(), simulation.Chassis(), vehicle);
  for (std::size_t i = 0; i < 4; ++i) {
    const WheelView wheel = simulation.Wheel(order[i]);
    const int spring = SpringAt(vehicle, order[i]);
    row.spring_force[i] = spring < 0 ? 0 : simulation.SpringForce(spring);
    row.wheel_height[i] = wheel.p_WH.z();
    row.tire_force[i] = wheel.load;
  }
  return row;
}

std::vector<TrajectoryRow> ReadTrajectory(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file + ": trajectory cannot be opened");
  std::string line;
  std::getline(stream, line);
  std::vector<TrajectoryRow> rows;
  for (int number = 2; std::getline(stream, line); ++number) {
    if (line.empty()) continue;
    rows.push_back(FromValues(ParseRow(line, file + ", line " + std::to_string(number))));
  }
  if (rows.size() < 2) throw InputError(file + ": needs a header and at least two rows");
  return rows;
}

void WriteTrajectory(const std::string& file, const std::vector<TrajectoryRow>& rows) {
  std::ofstream stream(file);
  std::string header;
  for (const std::string& name : TrajectoryColumns()) header += (header.empty() ? "" : ",") + name;
  stream << header << '\n';
  stream.precision(9);
  for (const TrajectoryRow& row : rows) {
    const RowValues values = ToValues(row);
    for (std::size_t i = 0; i < kColumns; ++i) stream << (i > 0 ? "," : "") << values[i];
    stream << '\n';
  }
  if (!stream.flush()) throw InputError(file + ": cannot be written");
}

std::vector<SignalAgreement> CompareTrajectories(const std::vector<TrajectoryRow>& rows,
                                                 const std::vector<TrajectoryRow>& reference) {
  const double end = std::min(rows.back().t, reference.back().t);
  if (end < kCompareFrom + 1) throw InputError("trajectories have too little time in common");
  const RowValues our_rest = Interpolate(rows, kCompareFrom);
  const RowValues their_rest = Interpolate(reference, kCompareFrom);
  std::array<Signal, kColumns> ours, theirs;
  for (std::size_t i = 0; i < kColumns; ++i) {
    ours[i].rest = our_rest[i];
    theirs[i].rest = their_rest[i];
  }
  for (const TrajectoryRow& row : reference) {
    if (row.t < kCompareFrom || row.t > end) continue;
    const RowValues a = Interpolate(rows, row.t), b = ToValues(row);
    for (std::size_t i = 0; i < kColumns; ++i) {
      ours[i].values.push_back(a[i] - our_rest[i]);
      theirs[i].values.push_back(b[i] - their_rest[i]);
    }
  }
  std::vector<SignalAgreement> result;
  const std::vector<std::string> names = TrajectoryColumns();
  for (std::size_t i = 2; i < kColumns; ++i) {
    const auto [low, high] = std::minmax_element(theirs[i].values.begin(), theirs[i].values.end());
    if (*high - *low < kLeastRange) continue;  // a signal that does not move says nothing
    result.push_back(Agreement(names[i], ours[i], theirs[i]));
  }
  return result;
}

}  // namespace dbd
