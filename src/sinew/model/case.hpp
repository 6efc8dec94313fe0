#pragma once
/// A case, understood: typed, complete (every default filled in) and never changed again. Each section describes its own keys;
/// the reader, its checks, the reference and the schema use that description.

#include <array>
#include <map>
#include <optional>
#include <sinew/core/node.hpp>
#include <sinew/core/units.hpp>
#include <sinew/model/contact_case.hpp>
#include <sinew/model/expect_case.hpp>
#include <sinew/model/expression.hpp>
#include <sinew/model/field_names.hpp>
#include <sinew/model/formulation_case.hpp>
#include <sinew/model/plane_state.hpp>
#include <sinew/model/registered_reader.hpp>
#include <sinew/model/solver_case.hpp>
#include <sinew/model/stage_case.hpp>
#include <string>
#include <utility>
#include <vector>

namespace sinew {

/// [case]
struct GeneralCase {
  std::string name, reference;
  int dimension = 3;
  PlaneState plane = PlaneState::strain;
  double thickness = 1.0;
  UnitSystem units;
  std::string tier = "quick";  ///< quick | full

  static void describe(auto&& field, auto& m) {
    constexpr Range two_or_three{2.0, 3.0, false, false, "2 or 3"};
    field("name", m.name, no_unit, "Name of the case; by default that of the file.", optional);
    field("reference", m.reference, no_unit, "Where the case comes from: paper and section.", optional);
    field("dimension", m.dimension, no_unit, "Number of dimensions.", two_or_three);
    field("plane", m.plane, no_unit, "What holds across the plane, in two dimensions only.", optional,
          OneOf{{"strain", "stress"}});
    field("thickness", m.thickness, "m", "Thickness across the plane, in two dimensions only.", positive, optional);
    field("units", m.units, no_unit, "The system of units that plain numbers are in.", optional);
    field("tier", m.tier, no_unit, "When `sinew verify` runs the case: always, or in the full tier only.", optional,
          OneOf{{"quick", "full"}});
  }
};

/// [[body]]
struct BodyCase {
  std::string name;
  AnyGeometry geometry;  ///< variant over the registered shapes
  std::string material_name;
  AnyMaterial material;
  std::optional<AnyDamage> damage;
  Place place;
  Place geometry_place;

  static void describe(auto&& field, auto& m) {
    field("name", m.name, no_unit, "Name of the body, by which regions and messages call it.");
    field("geometry", m.geometry, no_unit, "Shape and arrangement of the particles.", TypeText{"table with \"shape\""});
    field("material", m.material_name, no_unit, "Name of a [material.NAME] table, or the same table inline.",
          TypeText{"name, or table with \"model\""});
  }
};

/// A named particle set in reference coordinates; all conditions that are given must hold.  [region] NAME = {...}, or inline
struct RegionCase {
  std::string name;                         ///< inline ones are called after their owner
  std::string body;                         ///< empty: all bodies
  std::optional<Expression> where;          ///< true where not zero
  std::optional<std::array<Point, 2>> box;  ///< low, high
  std::optional<Point> nearest;             ///< the one particle nearest to this point
  std::string set;                          ///< a named set of the body's mesh
  bool is_inline = false;                   ///< belongs to one condition or probe and cannot be referred to
  Place place;

  static void describe(auto&& field, auto& m) {
    field("body", m.body, no_unit, "Only particles of this body.", optional, TypeText{"name of a body"});
    field("where", m.where, no_unit, "Only particles where this expression in X Y Z is true.", optional, TypeText{"condition"});
    field("box", m.box, "m", "Only particles inside this box (its faces included).", optional);
    field("nearest", m.nearest, "m", "Only the one particle nearest to this point.", optional);
    field("set", m.set, no_unit, "Only particles of this named set of the mesh file.", optional);
  }
};

/// What `region = ...` of a condition or a probe may be; see TypeText.
inline constexpr const char* region_type = "name of a region or a body, \"all\", or table { body, where, box, ... }";

/// [[initial]]
struct InitialCase {
  std::string region;  ///< key into Case::regions
  std::optional<std::array<Expression, 3>> velocity;
  std::optional<std::array<Expression, 3>> displacement;  ///< u(X)
  std::optional<std::array<double, 3>> stretch;           ///< x_i = stretch_i X_i, about the origin of coordinates
  Place place;

  static void describe(auto&& field, auto& m) {
    field("region", m.region, no_unit, "Where it holds.", TypeText{region_type});
    field("velocity", m.velocity, "m/s", "Velocity at time 0.", optional);
    field("displacement", m.displacement, "m", "Displacement at time 0, as a function of X Y Z.", optional);
    field("stretch", m.stretch, no_unit, "Stretch of each axis about the origin at time 0.", positive, optional);
  }
};

/// One prescribed quantity on a region. Components that are absent are free (motion) or zero (loads).  [[boundary]]
struct BoundaryCase {
  enum class Kind { displacement, velocity, force, traction, pressure, wall };
  std::string region;
  Kind kind = Kind::velocity;
  std::array<std::optional<Expression>, 3> value;  ///< pressure uses value[0]
  std::optional<Point> normal;  ///< pressure: outward normal in the reference configuration; wall: if it is smooth
  std::optional<double> area;   ///< traction, pressure: total area of the region's surface
  bool follower = false;        ///< pressure: on the current surface
  Place place;
};

/// [output]
struct OutputCase {
  double every = 0.0;             ///< 0: only the first and the last state
  double history_every = 0.0;     ///< 0: every step, in large cases one in particles / 20 000; up to 10 000 rows
  double checkpoint_every = 0.0;  ///< 0: only at the end or when interrupted
  std::vector<std::string> fields{"displacement", "velocity", "von_mises_stress", "pressure"};
  std::string precision = "double";  ///< of points and fields in the particle files: double | single
  std::string picture_field = "displacement";
  std::string picture;  ///< file name of the final picture inside the run folder; empty: none

  static void describe(auto&& field, auto& m) {
    field("every", m.every, "s", "Time between particle files; 0: only the first and the last state.", non_negative, optional);
    field("history_every", m.history_every, "s",
          "Time between rows of history.csv; 0: every step, in large cases one in particles / 20 000, up to 10 000 rows.",
          non_negative, optional);
    field("checkpoint_every", m.checkpoint_every, "s", "Time between checkpoints; 0: only at the end.", non_negative, optional);
    field("fields", m.fields, no_unit, "What the particle files hold.", optional, OneOf{field_names()});
    field("precision", m.precision, no_unit,
          "Of points and fields in the particle files; single: rounded to 7 digits, little more than half the size.", optional,
          OneOf{{"double", "single"}});
    field("picture_field", m.picture_field, no_unit, "Which field colors the picture.", optional, OneOf{field_names()});
    field("picture", m.picture, no_unit, "File name (.png) of a picture of the last state, in the run folder.", optional);
  }
};

/// [[probe]]
struct ProbeCase {
  std::string name;
  std::string quantity;  ///< a field or a total such as energy.kinetic; empty if `expression` is given
  std::string region;    ///< key into Case::regions; empty: all particles
  std::string reduce =
      "mean";             ///< sum | mean | rms | min | max; totals (energies, momenta, reaction force, time step) always have sum
  std::string component;  ///< "" for scalars; x y z xx xy ... magnitude
  std::optional<Expression> exact;
  std::string expression;  ///< over the names of earlier probes, parameters and t
  std::string wall;        ///< of wall_force
  Place place;

  static void describe(auto&& field, auto& m) {
    field("name", m.name, no_unit, "Name of the column in history.csv.");
    field("quantity", m.quantity, no_unit, "What is followed.", optional, OneOf{probe_quantity_names()});
    field("region", m.region, no_unit, "The particles; by default all.", optional, TypeText{region_type});
    field("reduce", m.reduce, no_unit, "How many particles become one number.", optional,
          OneOf{{"sum", "mean", "rms", "min", "max"}});
    field("exact", m.exact, no_unit,
          "Formula in X Y Z x y z t that is taken off the value of each particle; with reduce = \"rms\" (root of the mean square "
          "over the "
          "volume) that is the L2 norm of an error.",
          optional);
    field("component", m.component, no_unit, "x y z magnitude of a vector, xx xy ... of a tensor.", optional);
    field("wall", m.wall, no_unit, "For wall_force: which wall.", optional, TypeText{"name of a wall"});
    field("expression", m.expression, no_unit, "Instead of a quantity: a formula over earlier probes, the parameters and t.",
          optional);
  }
};

/// [body_force]
struct BodyForceCase {
  std::array<Expression, 3> acceleration;

  static void describe(auto&& field, auto& m) {
    field("acceleration", m.acceleration, "m/s^2", "Force per mass on every particle.");
  }
};

struct Case {
  GeneralCase general;
  std::map<std::string, double> parameters;
  std::vector<BodyCase> bodies;
  FormulationCase formulation;
  std::map<std::string, RegionCase> regions;  ///< the named ones, one for each body, "all", and the inline ones
  std::vector<InitialCase> initial;
  std::vector<BoundaryCase> boundary;
  std::array<Expression, 3> body_force;  ///< acceleration
  std::vector<ContactCase> contacts;
  std::vector<WallCase> walls;
  SolverCase solver;              ///< with stages, end_time is the sum of their durations
  std::vector<StageCase> stages;  ///< empty: the whole run is one
  OutputCase output;
  std::vector<ProbeCase> probes;
  std::vector<ExpectCase> expects;
  StudyCase study;
  std::string folder;  ///< of the case file, absolute
  Node resolved;       ///< the case with every default filled in, for case.resolved.toml
};

/// Understands a parsed case file. Throws CaseError with file:line:column, the value, what is allowed, the nearest known name.
Case make_case(const Node& root, const std::string& folder);

/// Puts `value` at the dotted `path` ("parameters.n", "body.0.geometry.spacing", "body.beam.material") as --set does: list
/// entries by number from 0 or by name. CaseError at the place of `value` for a parameter, entry or table that is not there;
/// another unknown key is reported by make_case.
void override_value(Node& root, const std::string& path, const Node& value);

/// Every section of the case file and its keys, in the order of the reference. [parameters] has none of its own.
std::vector<std::pair<std::string, std::vector<ParameterDoc>>> case_sections();

}  // namespace sinew
