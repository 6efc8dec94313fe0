#pragma once
/// From the conditions of a case to lists of particles and numbers.

#include <sinew/formulations/boundary/loads.hpp>
#include <sinew/formulations/boundary/prescribed_motion.hpp>
#include <sinew/formulations/formulation.hpp>
#include <sinew/formulations/wall_particles.hpp>
#include <sinew/model/case.hpp>
#include <sinew/model/regions.hpp>

namespace sinew {

// All of these are collective where ranks share a case.

/// Prescribed displacements and velocities. Where two conditions prescribe the same component of the same particle, the later one holds;
/// `warnings` gets a sentence.
template <int D>
PrescribedMotion<D> make_prescribed_motion(const Case& c, const Regions& regions, const Particles<D>& particles, const Comm& comm,
                                           std::vector<std::string>& warnings);

/// The body force, where it is the same everywhere and at all times; otherwise zero, and it is among the loads.
template <int D>
Vec<double, D> constant_body_force(const Case& c);

/// Particles that are walls, of all ranks.
template <int D>
WallTable<D> make_walls(const Case& c, const Regions& regions, const Particles<D>& particles, const Comm& comm);

/// Forces (shared by volume), tractions and pressures (by area). A particle's own area is one face of its cell, V^((D-1)/D); the normal of a
/// pressure is the direction away from its neighbors.
template <int D>
Loads<D> make_loads(const Case& c, const Regions& regions, const Particles<D>& particles, const Formulation<D>& solid,
                    const Comm& comm, std::vector<std::string>& warnings);

/// Displacements and velocities at time 0.
template <int D>
void set_initial_state(const Case& c, const Regions& regions, const Comm& comm, Particles<D>& particles);

}  // namespace sinew
