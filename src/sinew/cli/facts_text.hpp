#pragma once
/// What a case has become, for people.

#include <sinew/model/simulation.hpp>
#include <string>

namespace sinew {

/// Bodies with mass and wave speeds, particles, neighbors, time step, steps, memory, regions, warnings. Several lines.
std::string facts_text(const Case& c, const ModelFacts& facts);

/// Number of steps to the end if the time step stays as it is at the beginning.
double estimated_steps(const Case& c, const ModelFacts& facts);

/// Energies, their balance, momenta. `initial`: momenta at the start of the run.
std::string balance_text(const Case& c, const Energies& energies, const Momenta& momenta, const Momenta& initial);

}  // namespace sinew
