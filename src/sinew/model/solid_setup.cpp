#include <sinew/formulations/total_lagrangian.hpp>
#include <sinew/formulations/updated_lagrangian.hpp>
#include <sinew/model/conditions.hpp>
#include <sinew/model/solid_options.hpp>
#include <sinew/model/solid_setup.hpp>
#include <sinew/parallel/decomposition.hpp>

#include <fmt/format.h>

#include <cmath>

namespace sinew {

namespace {

template <int D>
Arrangement<D> arrangement_of(const Case& c, const std::vector<GeneratedBody>& bodies) {
  std::vector<BodyPoints> points;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    points.push_back({c.bodies[b].name, &bodies[b].points,
                      std::visit([](const auto& m) { return m.density; }, c.bodies[b].material), bodies[b].spacing});
  return arrange<D>(points, static_cast<int>(c.solver.block_size.value_or(largest_block)));
}

/// Of the particles of some blocks; 0 for the others, which then see nobody.
template <int D>
std::vector<double> support_radii(const Case& c, const Arrangement<D>& all, const std::vector<int>& blocks) {
  std::vector<double> radius(all.slots, 0.0), found;
  if (c.formulation.neighbors) found = radius_of_neighbors(all, *c.formulation.neighbors, blocks);
  for (const int number : blocks) {
    const BlockRange& block = all.blocks[number];
    const double uniform = c.formulation.support.value_or(FormulationCase::default_support) * all.bodies[block.body].spacing;
    for (int slot = block.begin; slot < block.end; ++slot) radius[slot] = found.empty() ? uniform : found[slot];
  }
  return radius;
}

double thickness_of(const Case& c) { return c.general.dimension == 3 ? 1.0 : c.general.thickness; }

/// The graph of blocks; each rank searches the neighbors of an equal share.
template <int D>
BlockGraph graph_of(const Case& c, const Arrangement<D>& all, const Comm& comm) {
  const std::vector<int> some = equal_share(static_cast<int>(all.blocks.size()), comm.rank(), comm.size());
  PairList list;
  comm.together([&] { list = build_pair_list(all, support_radii(c, all, some)); });
  return block_graph(comm, all, some, list);
}

/// Rank of each block.
template <int D>
std::vector<int> owners_of_blocks(const Case& c, const Arrangement<D>& all, const Comm& comm) {
  const BlockGraph graph = graph_of(c, all, comm);
  std::vector<int> owner;
  comm.on_root([&] { owner = partition(graph, comm.size()); });
  comm.broadcast(owner);
  return owner;
}

bool is_updated(const Case& c) { return c.formulation.model == UpdatedLagrangianOptions::name; }

/// On the current configuration all particles have one kernel radius, and so one spacing.
void check_spacings(const Case& c, const std::vector<GeneratedBody>& bodies) {
  if (!is_updated(c)) return;
  for (std::size_t b = 1; b < bodies.size(); ++b)
    if (std::abs(bodies[b].spacing - bodies[0].spacing) > 0.01 * bodies[0].spacing)
      throw CaseError(
          c.bodies[b].place,
          fmt::format("body \"{}\" has the particle spacing {:.4g}, body \"{}\" has {:.4g}; with \"updated_lagrangian\" all "
                      "bodies need the same",
                      c.bodies[b].name, bodies[b].spacing, c.bodies[0].name, bodies[0].spacing));
}

/// `all`: of all ranks.
template <int D>
std::unique_ptr<Formulation<D>> total_lagrangian(const Case& c, const SolidSetup<D>& setup, const Arrangement<D>& all,
                                                 SharedPairs<D> shared, const Comm& comm) {
  auto solid = std::make_unique<TotalLagrangian<D>>(setup.particles, std::move(shared.pairs), setup.support_radius,
                                                    total_lagrangian_options(c), comm, std::move(shared.halo));
  if (c.formulation.reference_update)
    solid->renew_by(std::make_unique<LaterReference<D>>(all, std::move(shared.share.owner), setup.particles,
                                                        c.formulation.reference_update->threshold, thickness_of(c)));
  return solid;
}

template <int D>
std::unique_ptr<Formulation<D>> updated_lagrangian(const Case& c, const SolidSetup<D>& setup, SharedPairs<D> shared,
                                                   const Comm& comm) {
  auto solid = std::make_unique<UpdatedLagrangian<D>>(setup.particles, std::move(shared.pairs),
                                                      updated_lagrangian_options(c, setup.particles.bodies.front().spacing), comm,
                                                      std::move(shared.halo));
  solid->stand_before(make_walls(c, setup.regions, setup.particles, comm));
  return solid;
}

template <int D>
SolidSetup<D> complete(const Case& c, SolidSetup<D> setup, const Arrangement<D>& all, SharedPairs<D> shared, const Comm& comm) {
  if (is_updated(c))
    setup.solid = updated_lagrangian(c, setup, std::move(shared), comm);
  else
    setup.solid = total_lagrangian(c, setup, all, std::move(shared), comm);
  return setup;
}

template <int D>
SolidSetup<D> set_up_alone(const Case& c, const Arrangement<D>& all, Regions regions, bool lattice) {
  std::vector<double> radius = support_radii(c, all, all.block_numbers());
  SharedPairs<D> shared;
  shared.pairs = make_block_pairs(all, build_pair_list(all, radius), radius, lattice);
  shared.share.owner.assign(all.blocks.size(), 0);
  return complete<D>(c, {Particles<D>(all, thickness_of(c)), std::move(regions), std::move(radius), nullptr}, all,
                     std::move(shared), Comm());
}

template <int D>
SolidSetup<D> set_up_share(const Case& c, const Arrangement<D>& all, Regions regions, bool lattice, const Comm& comm) {
  std::vector<int> owner = owners_of_blocks(c, all, comm), own;
  for (std::size_t b = 0; b < owner.size(); ++b)
    if (owner[b] == comm.rank()) own.push_back(static_cast<int>(b));
  std::vector<double> radius;
  comm.together([&] { radius = support_radii(c, all, own); });
  SharedPairs<D> shared = share_pairs(comm, all, std::move(owner), radius, lattice);
  const Share& share = shared.share;
  keep_own(regions, share);
  std::vector<double> own_radius(share.slots, 0.0);
  for (int slot = 0; slot < all.slots; ++slot)
    if (radius[slot] > 0.0) own_radius[share.local_of[slot]] = radius[slot];
  own_radius.resize(share.slots + share.copied(), 0.0);
  SolidSetup<D> setup{Particles<D>(part_of(all, share), thickness_of(c), share.copied()), std::move(regions),
                      std::move(own_radius), nullptr};
  return complete<D>(c, std::move(setup), all, std::move(shared), comm);
}

}  // namespace

template <int D>
SolidSetup<D> set_up(const Case& c, const std::vector<GeneratedBody>& bodies, const Comm& comm) {
  Arrangement<D> all;
  Regions regions;
  comm.together([&] {
    check_spacings(c, bodies);
    all = arrangement_of<D>(c, bodies);
    regions = select_regions(c, bodies, all);
  });
  const bool lattice = !is_updated(c) && may_use_lattice(total_lagrangian_options(c));
  if (comm.alone()) return set_up_alone(c, all, std::move(regions), lattice);
  return set_up_share(c, all, std::move(regions), lattice, comm);
}

template SolidSetup<2> set_up<2>(const Case&, const std::vector<GeneratedBody>&, const Comm&);
template SolidSetup<3> set_up<3>(const Case&, const std::vector<GeneratedBody>&, const Comm&);

}  // namespace sinew
