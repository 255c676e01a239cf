#include "continue_heights.h"

#include <limits>

namespace dbd {
namespace {

struct Step {
  int columns;
  int rows;
  float length;
};

class Continuation {
 public:
  Continuation(int columns, int rows, const Eigen::Vector2d& cell_size,
               const std::vector<std::uint8_t>& known, std::vector<float>* heights)
      : columns_(columns), rows_(rows), heights_(*heights), distances_(known.size()) {
    for (std::size_t i = 0; i < known.size(); ++i) {
      distances_[i] = known[i] ? 0.0F : std::numeric_limits<float>::infinity();
    }
    const auto east = static_cast<float>(cell_size.x());
    const auto north = static_cast<float>(cell_size.y());
    const auto diagonal = static_cast<float>(cell_size.norm());
    steps_ = {{-1, 0, east}, {-1, -1, diagonal}, {0, -1, north}, {1, -1, diagonal}};
  }

  // Towards the north-east, then back with the steps mirrored.
  void Sweep() {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) Visit(column, row);
    }
    for (Step& step : steps_) step = {-step.columns, -step.rows, step.length};
    for (int row = rows_ - 1; row >= 0; --row) {
      for (int column = columns_ - 1; column >= 0; --column) Visit(column, row);
    }
  }

 private:
  void Visit(int column, int row) {
    const std::size_t here = Index(column, row);
    for (const Step& step : steps_) {
      const int c = column + step.columns;
      const int r = row + step.rows;
      if (c < 0 || c >= columns_ || r < 0 || r >= rows_) continue;
      const float distance = distances_[Index(c, r)] + step.length;
      if (distance < distances_[here]) {
        distances_[here] = distance;
        heights_[here] = heights_[Index(c, r)];
      }
    }
  }

  std::size_t Index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + column;
  }

  int columns_;
  int rows_;
  std::vector<float>& heights_;
  std::vector<float> distances_;
  std::vector<Step> steps_;
};

}  // namespace

void ContinueFromNearest(int columns, int rows, const Eigen::Vector2d& cell_size,
                         const std::vector<std::uint8_t>& known, std::vector<float>* heights) {
  Continuation(columns, rows, cell_size, known, heights).Sweep();
}

}  // namespace dbd
