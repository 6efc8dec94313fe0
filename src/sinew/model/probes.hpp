#pragma once
/// Numbers that are followed over time.

#include <sinew/contact/contacts.hpp>
#include <sinew/model/case.hpp>
#include <sinew/model/conditions.hpp>
#include <sinew/model/fields.hpp>
#include <sinew/model/simulation.hpp>

namespace sinew {

/// What a probe looks at. `record`: null if no probe needs it (see needs_record).
template <int D>
struct ProbedState {
  const Comm& comm;
  const Particles<D>& particles;
  const Formulation<D>& solid;
  const PrescribedMotion<D>& motion;
  const Contacts<D>& contacts;
  const RecordedState* record;
  Energies energies;
  Momenta momenta;
  double time = 0.0, time_step = 0.0;
};

template <int D>
class Probes {
 public:
  Probes(const Case& c, const Regions& regions);

  bool need_record() const { return need_record_; }
  bool need_hourglass_error() const { return need_hourglass_error_; }
  /// Values of all probes, in the order of the case. Collective.
  std::vector<double> values(const ProbedState<D>& state) const;
  /// Units of the values in the system of the case; empty for an expression.
  std::vector<std::string> units() const;

 private:
  struct Probe {
    ProbeCase c;
    const QuantityInfo* quantity = nullptr;  ///< nullptr: an expression over t and the probes before it
    Expression formula;
    int component = 0;
    int wall = -1;           ///< among Case::walls
    std::vector<int> slots;  ///< on this rank
  };
  template <class Use>
  void for_each_value(const Probe& probe, const ProbedState<D>& state, Use&& use) const;
  double over_particles(const Probe& probe, const ProbedState<D>& state) const;
  double total(const Probe& probe, const ProbedState<D>& state) const;

  std::vector<Probe> probes_;
  UnitSystem units_;
  bool need_record_ = false, need_hourglass_error_ = false;
};

extern template class Probes<2>;
extern template class Probes<3>;

}  // namespace sinew
