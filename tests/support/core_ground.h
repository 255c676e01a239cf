#pragma once

#include <dbd/core/ground.h>

#include <functional>
#include <utility>

namespace dbd {

/// Ground of any shape, for tests; it knows no bound of its heights unless one is given.
class FunctionGround final : public Ground {
 public:
  using Shape = std::function<double(double, double)>;

  explicit FunctionGround(Shape shape, SoilSample soil = {})
      : shape_(std::move(shape)), soil_(soil) {}

  void Heights(int count, const double* x, const double* y, double* z) const override {
    for (int i = 0; i < count; ++i) z[i] = shape_(x[i], y[i]);
  }
  void Soils(int count, const double*, const double*, SoilSample* soil) const override {
    for (int i = 0; i < count; ++i) soil[i] = soil_;
  }

 private:
  Shape shape_;
  SoilSample soil_;
};

}  // namespace dbd
