/// Of SolidSimulation: what a checkpoint keeps of contacts and walls.

#include <sinew/model/solid_simulation.hpp>

#include <string>

namespace sinew {

/// CaseError unless the checkpoint has the histories, contacts and walls that the case has now.
template <int D>
void SolidSimulation<D>::check_same_parts(const SavedState& s) {
  const auto differ = [](const std::string& what) {
    throw CaseError("the checkpoint was written with other " + what +
                    " than the case has now. Resume with the case that wrote it.");
  };
  const auto history = s.fields.find("history");
  const int width = history == s.fields.end() ? 0 : history->second.width;
  if (width != solid_->history().width()) differ("materials or damage");
  const auto size = [&](const std::string& name) {
    const auto found = s.arrays.find(name);
    return found == s.arrays.end() ? std::size_t{0} : found->second.size();
  };
  const auto walls = static_cast<std::size_t>(contacts_.walls().count()), blocks = static_cast<std::size_t>(facts_.blocks);
  if (s.arrays.contains("contact") != contacts_.any()) differ("contacts or walls");
  if (contacts_.any() &&
      (size("contact") != 4 * blocks || size("wall_offsets") != D * walls || size("wall_forces") != D * walls * blocks))
    differ("walls");
}

template <int D>
void SolidSimulation<D>::save_contacts(SavedState& s) {
  if (!contacts_.any()) return;
  std::vector<double> sums, wall_forces;
  for (int b = 0; b < static_cast<int>(particles_.blocks.size()); ++b) {
    const ContactSums of_block = contacts_.sums()[b];
    sums.insert(sums.end(), {of_block.energy, of_block.dissipated, of_block.work, of_block.depth});
    const std::vector<double> forces = contacts_.walls().block_forces(b);
    wall_forces.insert(wall_forces.end(), forces.begin(), forces.end());
  }
  s.arrays["contact"] = gather_over_blocks(comm_, particles_.block_numbers(), sums, 4);
  s.arrays["wall_forces"] = gather_over_blocks(comm_, particles_.block_numbers(), wall_forces, D * contacts_.walls().count());
  s.arrays["wall_offsets"] = contacts_.walls().offsets();
  s.arrays["contact_limits"] = {contact_.rate2, contact_.approach};
}

template <int D>
void SolidSimulation<D>::restore_contacts(const SavedState& s) {
  const std::vector<double>&sums = s.arrays.at("contact"), &wall_forces = s.arrays.at("wall_forces");
  const int width = D * contacts_.walls().count();
  std::vector<std::vector<double>> forces;
  for (int b = 0; b < static_cast<int>(particles_.blocks.size()); ++b) {
    const auto number = static_cast<std::size_t>(particles_.blocks[b].number);
    ContactSums& of_block = contacts_.sums()[b];
    of_block = {sums[4 * number], sums[4 * number + 1], sums[4 * number + 2]};
    of_block.depth = sums[4 * number + 3];
    forces.emplace_back(wall_forces.begin() + number * width, wall_forces.begin() + (number + 1) * width);
  }
  contacts_.walls().restore(s.arrays.at("wall_offsets"), forces);
  contact_.rate2 = s.arrays.at("contact_limits")[0];
  contact_.approach = s.arrays.at("contact_limits")[1];
}

template void SolidSimulation<2>::check_same_parts(const SavedState&);
template void SolidSimulation<3>::check_same_parts(const SavedState&);
template void SolidSimulation<2>::save_contacts(SavedState&);
template void SolidSimulation<3>::save_contacts(SavedState&);
template void SolidSimulation<2>::restore_contacts(const SavedState&);
template void SolidSimulation<3>::restore_contacts(const SavedState&);

}  // namespace sinew
