#pragma once
/// [formulation] of a case.

#include <optional>
#include <sinew/core/node.hpp>
#include <sinew/model/registered_reader.hpp>
#include <string>
#include <vector>

namespace sinew {

/// [formulation] reference_update
struct ReferenceUpdateCase {
  double threshold = 2.0;

  static void describe(auto&& field, auto& m) {
    field("threshold", m.threshold, no_unit,
          "Largest change of the length of a pair, over its length in the reference configuration, at which that is renewed.",
          positive, optional);
  }
};
template <>
struct TypeName<ReferenceUpdateCase> {
  static constexpr const char* text = "table { threshold }";
};
inline Node read_value(ReferenceUpdateCase& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  if (!node.is(Node::Kind::table)) spec.wrong_kind(node, "a table such as { threshold = 2 }");
  return read_described(value, node, spec.label(), reading);
}

/// [formulation]
struct FormulationCase {
  std::string model = "total_lagrangian";
  AnyKernel kernel = Spiky{};       ///< wendland_c2 on the current configuration
  std::optional<double> support;    ///< kernel radius in particle spacings; either this or `neighbors`
  std::optional<double> neighbors;  ///< radius per particle so that about this many neighbors are inside it
  AnyCorrection correction = GradientCorrection{};
  std::string deformation_gradient = "direct";
  std::string momentum = "adjoint";
  bool project_angular_momentum = false;
  std::vector<AnyStabilization> stabilizations{HourglassStiffness{}};
  std::optional<ReferenceUpdateCase> reference_update;
  Place place;

  static constexpr double default_support = 2.41, default_moving_support = 3.0;

  static void describe(auto&& field, auto& m) {
    field("model", m.model, no_unit, "The formulation.", optional, OneOf{{"total_lagrangian", "updated_lagrangian"}});
    field("kernel", m.kernel, no_unit, "The smoothing kernel; spiky (updated_lagrangian: wendland_c2) if not given.", optional);
    field("support", m.support, no_unit,
          "Kernel radius in particle spacings; 2.41 (updated_lagrangian: 3) if neither this nor `neighbors` is given.",
          at_least_one, optional);
    field("neighbors", m.neighbors, no_unit, "Instead of `support`: a radius per particle with about this many neighbors inside.",
          at_least_one, optional);
    field("correction", m.correction, no_unit,
          "Correction of the kernel gradient; gradient if not given, none for updated_lagrangian without non_nested_shear.",
          optional);
    field("deformation_gradient", m.deformation_gradient, no_unit,
          "How the deformation gradient is computed: direct, from displacements; rate, integrated in time from velocities; bond, "
          "averaged over the bonds of a particle; bond_variational, the same, with the force that conserves its energy.",
          optional, OneOf{{"direct", "rate", "bond", "bond_variational"}});
    field("momentum", m.momentum, no_unit,
          "How stress becomes force: adjoint, what conserves energy with direct; symmetric, the mean stress of a pair. If not "
          "given, symmetric for rate and bond, adjoint for the others.",
          optional, OneOf{{"adjoint", "symmetric"}});
    field("project_angular_momentum", m.project_angular_momentum, no_unit,
          "Take the net moment out of the internal forces of each body, for methods that do not conserve angular momentum.",
          optional);
    field("stabilization", m.stabilizations, no_unit,
          "Treatments of zero-energy modes; [] or \"none\" for none. If not given hourglass_stiffness, for updated_lagrangian "
          "none.",
          optional);
    field("reference_update", m.reference_update, no_unit,
          "Make the current configuration the reference one whenever a pair has become longer or shorter by threshold (2 if not "
          "given) times its length there; never if this is not given.",
          optional);
  }
};

}  // namespace sinew
