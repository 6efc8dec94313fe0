#pragma once
/// [parameters]: numbers, quantities with units, and expressions over one another in any order.

#include <sinew/model/value_reader.hpp>

namespace sinew {

/// The value of every parameter. CaseError for a cycle, a name that means something else, or anything that is no number.
Constants evaluate_parameters(const Node& table, const Reading& reading);

}  // namespace sinew
