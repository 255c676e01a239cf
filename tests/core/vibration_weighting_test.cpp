#include <dbd/core/vibration_weighting.h>

#include <gtest/gtest.h>

#include <utility>

#include "support/core_printed.h"

namespace dbd {
namespace {

TEST(VibrationWeighting, PrintedTable) {
  const std::pair<double, double> vertical[] = {{0.5, 0.418246}, {1, 0.482473},  {2, 0.531411},
                                                {4, 0.967181},   {5, 1.03883},   {6.3, 1.05438},
                                                {8, 1.03637},    {16, 0.768699}, {31.5, 0.404751}};
  for (const auto& [frequency, gain] : vertical) ExpectPrinted(VerticalWeighting(frequency), gain);
  const std::pair<double, double> horizontal[] = {
      {0.5, 0.852821}, {1, 1.01102}, {2, 0.890243}, {4, 0.511912}, {8, 0.253125}};
  for (const auto& [frequency, gain] : horizontal) {
    ExpectPrinted(HorizontalWeighting(frequency), gain);
  }
}

}  // namespace
}  // namespace dbd
