#include "operation_counts.h"

namespace dbd {
namespace {

using enum Operation;

/// pack.h, Exp: range reduction, a series of four terms, scaling.
OperationCounts ExpOperations() {
  OperationCounts counts;
  counts[kExtreme] = 2;
  counts[kAdd] = 10;
  counts[kMultiply] = 10;
  counts[kFused] = 8;
  counts[kConvert] = 3;  // whole-number arithmetic on the exponent
  return counts;
}

/// pack.h, Cbrt: a guess from the exponent, two rounds of Halley's rule.
OperationCounts CbrtOperations() {
  OperationCounts counts;
  counts[kAdd] = 8;
  counts[kMultiply] = 7;
  counts[kDivide] = 2;
  counts[kCompare] = 1;
  counts[kSelect] = 1;
  counts[kConvert] = 3;
  return counts;
}

}  // namespace

OperationCounts& OperationCounts::operator+=(const OperationCounts& other) {
  for (std::size_t i = 0; i < kOperations; ++i) number[i] += other.number[i];
  return *this;
}

OperationCounts& OperationCounts::operator*=(double factor) {
  for (double& n : number) n *= factor;
  return *this;
}

OperationCounts Expanded(const OperationCounts& counts) {
  OperationCounts expanded = counts;
  expanded[kExponential] = expanded[kCubeRoot] = 0;
  expanded += ExpOperations() *= counts[kExponential];
  expanded += CbrtOperations() *= counts[kCubeRoot];
  return expanded;
}

double Flops(const OperationCounts& counts) {
  return counts[kAdd] + counts[kMultiply] + counts[kDivide] + counts[kSquareRoot];
}

double SimpleOperations(const OperationCounts& counts) {
  return counts[kAdd] + counts[kMultiply] + counts[kCompare] + counts[kExtreme] + counts[kSelect] +
         counts[kAbsolute] + counts[kConvert];
}

}  // namespace dbd
