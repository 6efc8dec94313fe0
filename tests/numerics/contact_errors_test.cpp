/// Contacts and walls that cannot be meant as they are written, and checkpoints of other cases.

#include <gtest/gtest.h>

#include "two_balls.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

std::string error_of(const std::string& text) {
  try {
    simulation_of(text);
  } catch (const CaseError& error) {
    return error.what();
  }
  return "none";
}

TEST(Contact, WhatCannotBeMeantIsAnError) {
  const auto has = [](const std::string& message, const std::string& part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  has(error_of(two_balls(2, "bodies = [\"a\", \"a\"]\n")), "named twice");
  has(error_of(two_balls(2, "bodies = [\"a\"]\n")), "one body touches nobody");
  has(error_of(two_balls(2, "bodies = []\n")), "name at least one");
  has(error_of(two_balls(2, "bodies = [\"a\", \"c\"]\n")), "unknown body \"c\"");
  has(error_of(two_balls(2, "friction = -0.1\n")), "0 or greater");
  has(error_of(two_balls(2, "damping = 2\n")), "from 0 to 1");
  has(error_of(two_balls(2, "\n[[contact]]\n")), "already described above");
  const std::string tool =
      "[material.steel]\nmodel = \"rigid\"\ndensity = 1\n[[body]]\nname = \"tool\"\nmaterial = \"steel\"\ngeometry = { shape = "
      "\"box\", low "
      "= [3, 0], high = [4, 1], spacing = 0.1 }\n";
  has(error_of(two_balls(2, "", tool)), "is rigid, but the motion of its particle");
  has(error_of(two_balls(2, "", tool + "[[boundary]]\nregion = \"tool\"\nvelocity = [0, \"free\"]\n")),
      "along y is not prescribed");
  const std::string held = tool + "[[boundary]]\nregion = \"tool\"\nvelocity = [0, 0]\n";
  EXPECT_EQ(error_of(two_balls(2, "", held)), "none");
  has(error_of(two_balls(2, "",
                         held + "[[wall]]\nname = \"w\"\ngeometry = { shape = \"plane\", point = [0, -9], normal = [0, 1] }\n")),
      "give \"stiffness\"");
  has(error_of(two_balls(2, "",
                         "[[wall]]\nname = \"w\"\ngeometry = { shape = \"plane\", point = [0, -9], normal = [0, 1] }\nvelocity = "
                         "[0, \"1/t\"]\n")),
      "not a finite number at t = 0");
}

/// A checkpoint of a case with other contacts, walls or materials is refused, not misread.
TEST(Contact, OtherPartsThanInTheCheckpointAreAnError) {
  const auto plain = simulation_of(two_balls(2));
  const SavedState saved = plain->save();
  const auto refuses = [&](const std::string& text) {
    const auto other = simulation_of(text);
    EXPECT_THROW(other->restore(saved), CaseError);
  };
  std::string without = two_balls(2);
  without.erase(without.find("[[contact]]\n"), 12);
  refuses(without);
  refuses(two_balls(2, "", "[[wall]]\nname = \"w\"\ngeometry = { shape = \"plane\", point = [0, -9], normal = [0, 1] }\n"));
  std::string damaged = two_balls(2);
  damaged.replace(damaged.find("density = 1.0"), 13, "density = 1.0\ndamage = { model = \"principal_strain\", threshold = 9 }");
  refuses(damaged);
}

TEST(Contact, OverlappingBodiesAreAnError) {
  std::string text = two_balls(2);
  text.replace(text.find("center = [0.56"), 14, "center = [0.40");
  try {
    simulation_of(text);
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("bodies \"a\" and \"b\" overlap at the start"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sinew
