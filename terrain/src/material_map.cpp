#include <dbd/core/error.h>
#include <dbd/terrain/material_map.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dbd {
namespace {

SoilSample SoftestPassable(const std::vector<Material>& materials) {
  const Material* softest = nullptr;
  for (const Material& material : materials) {
    if (!material.passable) continue;
    if (softest == nullptr || material.soil.cone_index < softest->soil.cone_index) {
      softest = &material;
    }
  }
  return softest != nullptr ? softest->soil : materials.front().soil;
}

}  // namespace

MaterialMap::MaterialMap(const Material& everywhere) : table_("uniform", {everywhere}) {
  soils_.fill(everywhere.soil);
}

MaterialMap::MaterialMap(MaterialTable table, const HeightMap::Grid& grid,
                         std::vector<std::uint8_t> indices)
    : table_(std::move(table)),
      grid_(grid),
      cells_{grid.columns,           grid.rows,
             grid.first_center.x(),  grid.first_center.y(),
             1 / grid.cell_size.x(), 1 / grid.cell_size.y()},
      indices_(std::move(indices)) {
  DBD_ASSERT(indices_.size() == grid_.CellCount() && !indices_.empty());
  const std::vector<Material>& materials = table_.materials();
  for (const std::uint8_t index : indices_) {
    DBD_ASSERT(index == kNone || index < materials.size());
  }
  soils_.fill(SoftestPassable(materials));
  for (std::size_t i = 0; i < materials.size(); ++i) soils_[i] = materials[i].soil;
}

MaterialMap MaterialMap::WithMaterials(std::vector<Material> materials) const {
  DBD_ASSERT(materials.size() == table_.materials().size());
  if (is_uniform()) return MaterialMap(materials.front());
  return MaterialMap(MaterialTable(table_.name(), std::move(materials)), grid_, indices_);
}

const Material* MaterialMap::At(double x, double y) const {
  if (is_uniform()) return &table_.materials().front();
  const std::uint8_t index = IndexAt(x, y);
  return index == kNone ? nullptr : &table_.materials()[index];
}

void MaterialMap::Soils(int count, const double* x, const double* y, SoilSample* soil) const {
  if (is_uniform()) {
    std::fill_n(soil, count, soils_[0]);
    return;
  }
  for (int i = 0; i < count; ++i) soil[i] = soils_[IndexAt(x[i], y[i])];
}

GroundSoils MaterialMap::View() const {
  GroundSoils view;
  view.soils = soils_.data();
  view.count = 1;
  if (is_uniform()) return view;
  view.count = static_cast<int>(soils_.size());
  view.classes = indices_.data();
  view.grid = cells_;
  view.outside = kNone;
  return view;
}

double MaterialMap::Share(std::uint8_t index) const {
  if (is_uniform()) return index == 0 ? 1.0 : 0.0;
  return static_cast<double>(std::count(indices_.begin(), indices_.end(), index)) /
         static_cast<double>(indices_.size());
}

std::uint8_t MaterialMap::IndexAt(double x, double y) const {
  const std::ptrdiff_t cell = cells_.CellAt(x, y);
  return cell < 0 ? kNone : indices_[static_cast<std::size_t>(cell)];
}

}  // namespace dbd
