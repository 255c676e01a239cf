#include <dbd/core/ride.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace dbd {
namespace {

constexpr double kFeet = 1 / 0.3048;  // per metre

// Polynomials in s of the absorbed-power filter, lowest power first: 14.5 s (s + 44) over
// (s + 63)(s^2 + 24 s + 750).
constexpr std::array<double, 4> kNumerator = {0, 14.5 * 44, 14.5, 0};
constexpr std::array<double, 4> kDenominator = {63.0 * 750, 750 + 63.0 * 24, 24 + 63.0, 1};

/// Coefficients in 1/z of sum of p_k s^k with s = scale (1 - 1/z)/(1 + 1/z), times (1 + 1/z)^N.
template <std::size_t kSize>
std::array<double, kSize> Bilinear(const std::array<double, kSize>& p, double scale) {
  std::array<double, kSize> sum{};
  double power = 1;
  for (std::size_t k = 0; k < kSize; ++k) {
    std::array<double, kSize> term{};
    term[0] = p[k] * power;
    for (std::size_t factor = 0; factor + 1 < kSize; ++factor) {
      const double sign = factor < k ? -1 : 1;
      for (std::size_t i = kSize - 1; i > 0; --i) term[i] += sign * term[i - 1];
    }
    for (std::size_t i = 0; i < kSize; ++i) sum[i] += term[i];
    power *= scale;
  }
  return sum;
}

template <std::size_t kSize>
LinearFilter<static_cast<int>(kSize) - 1> MakeFilter(const std::array<double, kSize>& numerator,
                                                     const std::array<double, kSize>& denominator,
                                                     double scale) {
  LinearFilter<static_cast<int>(kSize) - 1> filter;
  filter.b = Bilinear(numerator, scale);
  filter.a = Bilinear(denominator, scale);
  const double lead = filter.a[0];
  for (std::size_t i = 0; i < kSize; ++i) {
    filter.b[i] /= lead;
    filter.a[i] /= lead;
  }
  return filter;
}

/// 1 / (s^2 + s/Q + 1), with the frequency scale warped so that the cut-off is exact.
LinearFilter<2> LowPassSection(double quality, double cutoff, double step) {
  const double scale = 1 / std::tan(std::numbers::pi * cutoff * step);
  return MakeFilter(std::array{1.0, 0.0, 0.0}, std::array{1.0, 1 / quality, 1.0}, scale);
}

double ButterworthQuality(int section) {
  return 1 / (2 * std::sin((2 * section + 1) * std::numbers::pi / 8));
}

}  // namespace

LinearFilter<3> AbsorbedPowerFilter(double step) {
  return MakeFilter(kNumerator, kDenominator, 2 / step);
}

double AbsorbedPowerGain(double frequency) {
  const std::complex<double> s(0, 2 * std::numbers::pi * frequency);
  const std::complex<double> h = 14.5 * s * (s + 44.0) / ((s + 63.0) * (s * s + 24.0 * s + 750.0));
  return std::norm(h) * kFeet * kFeet;
}

AbsorbedPower::AbsorbedPower(double step)
    : filter_(AbsorbedPowerFilter(step)),
      samples_per_bin_(std::max(1, static_cast<int>(std::lround(kWindow / kBins / step)))) {}

void AbsorbedPower::BeginBin() {
  newest_ = (newest_ + 1) % (kBins + 1);
  sums_[static_cast<std::size_t>(newest_)] = 0;
  samples_ = 0;
  complete_ = 0;  // summed anew, so that round-off does not gather
  for (const double bin : sums_) complete_ += bin;
}

void AbsorbedPower::Update(std::span<const double> accelerations) {
  LinearFilter<3> filter = filter_;
  while (!accelerations.empty()) {
    if (samples_ == samples_per_bin_) BeginBin();
    const auto room = static_cast<std::size_t>(samples_per_bin_ - samples_);
    const std::size_t count = std::min(room, accelerations.size());
    double sum = sums_[static_cast<std::size_t>(newest_)];
    for (const double acceleration : accelerations.first(count)) {
      const double root = filter.Update(acceleration * kFeet);
      sum += root * root;
    }
    sums_[static_cast<std::size_t>(newest_)] = sum;
    samples_ += static_cast<int>(count);
    accelerations = accelerations.subspan(count);
  }
  filter_ = filter;
}

double AbsorbedPower::mean() const {
  const double oldest = sums_[static_cast<std::size_t>((newest_ + 1) % (kBins + 1))];
  const double left = static_cast<double>(samples_) / samples_per_bin_;  // share of it outside
  const double sum = complete_ + sums_[static_cast<std::size_t>(newest_)] - left * oldest;
  return std::max(0.0, sum / (kBins * samples_per_bin_));
}

ButterworthLowPass::ButterworthLowPass(double cutoff, double step)
    : first_(LowPassSection(ButterworthQuality(0), cutoff, step)),
      second_(LowPassSection(ButterworthQuality(1), cutoff, step)) {}

double RideMeter::Update(std::span<const double> vertical_accelerations) {
  power_.Update(vertical_accelerations);
  ButterworthLowPass low_pass = low_pass_;
  double squares = 0;
  for (const double acceleration : vertical_accelerations) {
    const double smooth = low_pass.Update(acceleration);
    peak_ = std::max(peak_, std::abs(smooth));
    squares += smooth * smooth;
  }
  low_pass_ = low_pass;
  return squares;
}

double RideMeter::TakePeak() {
  const double peak = peak_;
  peak_ = 0;
  return peak;
}

}  // namespace dbd
