#pragma once
/// From the walls and contacts of a case to what pushes particles.

#include <sinew/contact/contacts.hpp>
#include <sinew/model/case.hpp>
#include <sinew/parallel/comm.hpp>

namespace sinew {

/// Collective.
template <int D>
Contacts<D> make_contacts(const Case& c, const Particles<D>& particles, const std::vector<double>& support_radius,
                          const Comm& comm);

/// CaseError where bodies are inside walls or one another at the start, of which the contacts know the forces. Collective.
template <int D>
void check_initial_contacts(const Case& c, const Contacts<D>& contacts, const Particles<D>& particles, const Comm& comm);

}  // namespace sinew
