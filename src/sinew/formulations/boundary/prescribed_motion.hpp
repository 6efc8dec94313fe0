#pragma once
/// Particles whose displacement or velocity is given, component by component, and the forces that hold them there.

#include <sinew/core/field_function.hpp>
#include <sinew/core/function_ref.hpp>
#include <sinew/particles/particles.hpp>
#include <vector>

namespace sinew {

/// One component of the motion of a set of particles.
struct MotionCondition {
  enum class Kind { displacement, velocity };
  Kind kind = Kind::velocity;
  int component = 0;
  FieldFunction function;  ///< [length] or [length/time]
  std::vector<int> slots;
};

/// In a step from t to t + dt: `remember` before the drift, `move` after it, `hold` when the new forces are known.
template <int D>
class PrescribedMotion {
 public:
  PrescribedMotion() = default;
  PrescribedMotion(std::vector<MotionCondition> conditions, const Particles<D>& particles);

  void remember(const Particles<D>& particles);
  /// Puts the particles where they have to be at t + dt: u = function(t + dt), or u += dt function(t + dt/2); their velocities are the means over the step.
  void move(Particles<D>& particles, double t, double dt);
  /// At time 0, once the length of the first step is known: gives the particles the velocity and the acceleration with which they begin, without any work.
  void begin(Particles<D>& particles, double dt, double damping);
  /// For the stages of a step of length dt: u = function(t) and its velocity, or v = function(t).
  void impose(Particles<D>& particles, double t, double dt) const;
  /// Sets velocity and acceleration at time t to the prescribed ones and takes the difference in force as reaction:
  /// R = m (a_prescribed + damping v) - (internal + hourglass + external force). `dt`: length of the step, 0 at the start; `damping`: rate [1/time].
  void hold(Particles<D>& particles, double t, double dt, double damping);

  /// The same in static balance, where the force that is missing is mass times acceleration: nothing moves. `counts`: the work since `remember`.
  void hold_still(Particles<D>& particles, bool counts);
  /// Calls use(slot, component) for all components that are given.
  void for_each(FunctionRef<void(int, int)> use) const;

  /// Sum of the reactions on some particles, given by ascending slots, for each block [force].
  std::vector<Vec<double, D>> reactions_on(const std::vector<int>& slots) const;
  /// Done by the reactions on the particles of each block so far [energy].
  const std::vector<double>& work() const { return work_; }

  /// A reaction that a restart needs: everything else is a function of particles and time.
  struct Reaction {
    int condition, slot;
    double value;
  };
  std::vector<Reaction> reactions() const;
  /// `reaction(condition, slot)` gives them back.
  void restore(FunctionRef<double(int, int)> reaction, std::vector<double> work);

 private:
  struct Entry {
    int slot, block;
    double previous_u = 0.0, reaction = 0.0;
  };
  struct Held {
    MotionCondition condition;
    std::vector<Entry> entries;
  };
  std::vector<Held> conditions_;
  std::vector<double> work_;
};

extern template class PrescribedMotion<2>;
extern template class PrescribedMotion<3>;

}  // namespace sinew
