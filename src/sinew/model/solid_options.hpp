#pragma once
/// From a case to the options of its formulation.

#include <sinew/formulations/total_lagrangian.hpp>
#include <sinew/formulations/updated_lagrangian.hpp>
#include <sinew/model/case.hpp>

namespace sinew {

TotalLagrangianOptions total_lagrangian_options(const Case& c);
/// `spacing`: of the particles of all bodies.
UpdatedLagrangianOptions updated_lagrangian_options(const Case& c, double spacing);

}  // namespace sinew
