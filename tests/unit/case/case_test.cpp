#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sinew/io/read_toml.hpp>
#include <sinew/io/write_toml.hpp>
#include <sinew/model/case.hpp>

#include "errors/wrong_case.hpp"

namespace sinew {
namespace {

Case case_of(const std::string& text, const std::string& folder = "/data/run") {
  return make_case(read_toml_text(text, "case.toml"), folder);
}

/// The smallest case in two dimensions; `more` is added at its end.
std::string plane_case(const std::string& more, const std::string& units = "") {
  return "[case]\ndimension = 2\n" + units +
         "[[body]]\nname = \"beam\"\ngeometry = { shape = \"box\", low = [0, 0], high = [8, 1], spacing = 0.25 }\n"
         "material = { model = \"linear_elastic\", density = \"1 g/cm^3\", youngs_modulus = \"100 GPa\", poissons_ratio = 0.3 }\n"
         "[solver]\nend_time = 2\n" +
         more;
}

TEST(MakeCase, UnderstandsEverySection) {
  const Case c = case_of(good_case);
  EXPECT_EQ(c.general.name, "column");
  EXPECT_EQ(c.general.dimension, 3);
  EXPECT_EQ(c.parameters.at("n"), 6.0);
  const Box& box = std::get<Box>(c.bodies.at(0).geometry);
  EXPECT_EQ(box.arrangement.spacing, 1.0 / 6.0);
  EXPECT_EQ(box.high, (std::vector<double>{1, 1, 6}));
  const NeoHookean& rubber = std::get<NeoHookean>(c.bodies[0].material);
  EXPECT_EQ(rubber.density, 1100.0);
  EXPECT_EQ(rubber.elastic.youngs_modulus, 17e6);
  EXPECT_DOUBLE_EQ(rubber.elastic.mu(), 17e6 / 2.9);
  EXPECT_TRUE(std::holds_alternative<CubicSpline>(c.formulation.kernel));
  EXPECT_EQ(c.formulation.support, 2.4);
  EXPECT_EQ(c.regions.at("foot").body, "column");
  EXPECT_NE((*c.regions.at("foot").where)({{0, 0, 0.1}}, {}, 0.0), 0.0);
  EXPECT_EQ((*c.regions.at("foot").where)({{0, 0, 0.2}}, {}, 0.0), 0.0);
  EXPECT_EQ((*c.initial.at(0).velocity)[0]({}, {{0, 2, 0}}, 0.0), -210.0);
  EXPECT_EQ(c.boundary.at(0).kind, BoundaryCase::Kind::velocity);
  EXPECT_EQ(c.solver.end_time, 0.5);
  EXPECT_EQ(c.output.every, 0.01);
  EXPECT_EQ(c.output.fields, (std::vector<std::string>{"velocity"}));
  EXPECT_EQ(c.probes.at(0).component, "z");
  EXPECT_EQ(c.expects.at(0).probe, "tip");
  EXPECT_EQ(c.expects[0].reduction, "min");
  EXPECT_EQ(c.folder, "/data/run");
}

TEST(MakeCase, FillsInTheDefaults) {
  const Case c = case_of(plane_case(""));
  EXPECT_EQ(c.general.name, "case");  // of case.toml
  EXPECT_EQ(c.general.plane, PlaneState::strain);
  EXPECT_TRUE(std::holds_alternative<Spiky>(c.formulation.kernel));
  EXPECT_EQ(c.formulation.support, 2.41);
  EXPECT_FALSE(c.formulation.neighbors);
  EXPECT_TRUE(std::holds_alternative<GradientCorrection>(c.formulation.correction));
  ASSERT_EQ(c.formulation.stabilizations.size(), 1u);
  EXPECT_EQ(std::get<HourglassStiffness>(c.formulation.stabilizations[0]).alpha, 50.0);
  EXPECT_EQ(c.solver.cfl, 0.3);
  EXPECT_EQ(c.regions.at("beam").body, "beam");
  EXPECT_EQ(c.regions.at("all").body, "");
  EXPECT_EQ(c.body_force[1](0.0), 0.0);
}

TEST(MakeCase, StabilizationMayBeSwitchedOffAndShortened) {
  EXPECT_TRUE(case_of(plane_case("[formulation]\nstabilization = []\n")).formulation.stabilizations.empty());
  EXPECT_TRUE(case_of(plane_case("[formulation]\nstabilization = \"none\"\n")).formulation.stabilizations.empty());
  EXPECT_EQ(case_of(plane_case("[formulation]\nstabilization = \"hourglass_stiffness\"\n")).formulation.stabilizations.size(),
            1u);
  const Case c = case_of(plane_case("[formulation]\nneighbors = 12\nstabilization = [\"hourglass_stiffness\"]\n"));
  EXPECT_EQ(c.formulation.neighbors, 12.0);
  EXPECT_FALSE(c.formulation.support);
}

TEST(MakeCase, ConvertsUnitsIntoTheSystemOfTheCase) {
  const Case c = case_of(plane_case("[body_force]\nacceleration = [0, \"-10 m/s^2\"]\n",
                                    "units = { length = \"mm\", mass = \"kg\", time = \"ms\" }\nthickness = \"2 cm\"\n"));
  const LinearElastic& steel = std::get<LinearElastic>(c.bodies.at(0).material);
  EXPECT_DOUBLE_EQ(steel.density, 1e-6);                  // kg/mm^3
  EXPECT_DOUBLE_EQ(steel.elastic.youngs_modulus, 100.0);  // GPa
  EXPECT_DOUBLE_EQ(c.general.thickness, 20.0);            // mm
  EXPECT_DOUBLE_EQ(c.body_force[1](0.0), -0.01);          // mm/ms^2
  EXPECT_EQ(c.general.units.name_of("Pa"), "GPa");
}

TEST(MakeCase, BoundariesKeepOneQuantityAndFreeComponents) {
  const Case c = case_of(plane_case(
      "[[boundary]]\nregion = { where = \"X < 1\", body = \"beam\" }\ndisplacement = [\"free\", \"0.1*t\"]\n"
      "[[boundary]]\nregion = { box = { low = [7, 0], high = [8, 1] } }\npressure = \"2 kPa\"\nnormal = [1, 0]\n"
      "[[boundary]]\nregion = \"beam\"\nforce = [1, \"t\"]\n[[boundary]]\nregion = \"all\"\ntraction = [0, 1]\narea = 2\n"));
  ASSERT_EQ(c.boundary.size(), 4u);
  EXPECT_FALSE(c.boundary[0].value[0]);
  EXPECT_EQ((*c.boundary[0].value[1])(2.0), 0.2);
  EXPECT_FALSE(c.boundary[0].value[2]);
  const RegionCase& inline_region = c.regions.at(c.boundary[0].region);
  EXPECT_TRUE(inline_region.is_inline);
  EXPECT_EQ(inline_region.body, "beam");
  EXPECT_EQ((*c.regions.at(c.boundary[1].region).box)[1][0], 8.0);
  EXPECT_EQ(c.boundary[1].kind, BoundaryCase::Kind::pressure);
  EXPECT_EQ((*c.boundary[1].value[0])(0.0), 2000.0);
  EXPECT_EQ((*c.boundary[2].value[1])(3.0), 3.0);
  EXPECT_EQ(c.boundary[3].area, 2.0);
}

TEST(MakeCase, InitialStretchAndMaxSteps) {
  const Case c = case_of(plane_case("max_steps = \"2*5\"\n[[initial]]\nregion = \"all\"\nstretch = [1.1, 1.2]\n"));
  EXPECT_EQ((*c.initial.at(0).stretch), (std::array<double, 3>{1.1, 1.2, 1.0}));
  EXPECT_EQ(c.solver.max_steps, 10);
  const Case open = case_of(
      "[case]\ndimension = 2\n[[body]]\nname = \"a\"\ngeometry = { shape = \"points\", file = \"a.csv\" }\n"
      "material = { model = \"linear_elastic\", density = 1, bulk_modulus = 1, shear_modulus = 1 }\n[solver]\nmax_steps = 3\n");
  EXPECT_EQ(open.solver.end_time, std::numeric_limits<double>::infinity());
}

TEST(MakeCase, ProbesExpectsAndStudy) {
  const Case c =
      case_of(plane_case("[parameters]\nn = 4\n[[probe]]\nname = \"energy\"\nquantity = \"energy.total\"\n"
                         "[[probe]]\nname = \"double_energy\"\nexpression = \"n*energy + t\"\n"
                         "[[expect]]\nquantity = \"probe.energy.at(end_time/4)\"\nvalue = \"1 kJ\"\nabsolute = 0.1\ntier = "
                         "\"full\"\nwith = { \"parameters.n\" = 8 }\n"
                         "[[expect]]\nquantity = \"probe.double_energy.rate\"\nvalue = 2\ntolerance = 0.1\nexact = 0\n"
                         "[study]\nvary = { \"parameters.n\" = [4, \"2*4\"] }\n"));
  EXPECT_EQ(c.probes.at(0).reduce, "sum");
  EXPECT_EQ(c.probes[0].region, "");
  EXPECT_EQ(c.probes.at(1).expression, "n*energy + t");
  EXPECT_EQ(c.expects.at(0).reduction, "at");
  EXPECT_EQ(c.expects[0].time, 0.5);
  EXPECT_EQ(c.expects[0].value, 1000.0);
  EXPECT_EQ(c.expects[0].with, (std::vector<std::pair<std::string, double>>{{"parameters.n", 8.0}}));
  EXPECT_EQ(c.expects.at(1).exact, 0.0);
  EXPECT_EQ(c.study.vary.at(0).second, (std::vector<double>{4, 8}));
}

TEST(MakeCase, PolygonsMayBeListsOfPoints) {
  const std::string start =
      "[case]\ndimension = 2\n[[body]]\nname = \"a\"\nmaterial = { model = \"linear_elastic\", density = 1, "
      "bulk_modulus = 1, shear_modulus = 1 }\n[solver]\nend_time = 1\n";
  std::string text = start;
  text.replace(text.find("material"), 0,
               "geometry = { shape = \"polygon\", points = [[0, 0], [1, 0], [\"1/2\", 1]], spacing = 0.1 }\n");
  EXPECT_EQ(std::get<Polygon>(case_of(text).bodies[0].geometry).points, (std::vector<double>{0, 0, 1, 0, 0.5, 1}));
}

void expect_same_again(const std::string& text) {
  const Case first = case_of(text);
  const std::string resolved = toml_text(first.resolved);
  const Case second = make_case(read_toml_text(resolved, "elsewhere.toml"), "/somewhere/else");
  EXPECT_EQ(toml_text(second.resolved), resolved);
  EXPECT_EQ(second.general.name, first.general.name);
  EXPECT_EQ(second.solver.end_time, first.solver.end_time);
  EXPECT_EQ(second.output.every, first.output.every);
  EXPECT_EQ(second.formulation.support, first.formulation.support);
  EXPECT_EQ(second.probes.size(), first.probes.size());
  EXPECT_EQ(second.boundary.size(), first.boundary.size());
  EXPECT_EQ(second.regions.size(), first.regions.size());
  EXPECT_EQ(second.parameters, first.parameters);
}

TEST(Resolved, ReadsBackToTheSameCase) {
  expect_same_again(good_case);
  expect_same_again(plane_case(""));
  expect_same_again(
      plane_case("max_steps = 3\n[formulation]\nneighbors = 12\nstabilization = []\n[[boundary]]\nregion = { where = \"X<1\" }\n"
                 "velocity = [0, \"free\"]\n[[probe]]\nname = \"a\"\nquantity = \"energy.total\"\nregion = { nearest = [0, 0] }\n"
                 "[[probe]]\nname = \"b\"\nexpression = \"a^2\"\n[study]\nvary = { \"solver.cfl\" = [0.1, 0.2] }\n",
                 "units = { length = \"mm\", mass = \"kg\", time = \"ms\" }\n"));
}

TEST(Resolved, HasTheDefaultsTheOverridesAndAbsoluteFiles) {
  Node root = read_toml_text(plane_case("time_step = 0.1\n"), "case.toml");
  override_value(root, "body.beam.geometry", read_toml_value("{ shape = \"mesh\", file = \"../mesh.msh\" }", Place{"--set"}));
  const Case c = make_case(root, "/data/run");
  EXPECT_EQ(std::get<MeshFile>(c.bodies[0].geometry).file, "/data/mesh.msh");
  const std::string text = toml_text(c.resolved);
  EXPECT_NE(text.find("file = \"/data/mesh.msh\", scale = 1.0"), std::string::npos) << text;
  EXPECT_NE(text.find("stabilization = [{ model = \"hourglass_stiffness\", alpha = 50.0, normalization = \"conservative\", "
                      "plastic_switch = true }]"),
            std::string::npos);
  EXPECT_NE(text.find("time_step = 0.1"), std::string::npos);
}

}  // namespace
}  // namespace sinew
