#include <sinew/cli/templates.hpp>

namespace sinew {

namespace {

constexpr const char* beam =
    R"toml(# A beam, clamped on the left, is set swinging by an upward velocity. Two dimensions, plane strain.
# Check it with `sinew check`, run it with `sinew run`; `sinew describe solver` (or any other section) lists all keys.

[case]
name = "beam"
dimension = 2                # 2 or 3
plane = "strain"             # or "stress"
units = "SI"                 # or for example { length = "mm", mass = "kg", time = "ms" }

[parameters]                 # names for numbers; sinew run beam.toml --set parameters.n=16
n = 8                        # particles across the height
length = 0.2
height = 0.02
spacing = "height/n"
speed = 0.5                  # initial velocity of the tip

[[body]]
name = "beam"
geometry = { shape = "box", low = [0, 0], high = ["length", "height"], spacing = "spacing" }
material = "polymer"

[material.polymer]
model = "neo_hookean"        # `sinew list materials`
density = 1000
youngs_modulus = "2 MPa"     # give any two of the five elastic constants
poissons_ratio = 0.4

[formulation]
model = "total_lagrangian"
kernel = "wendland_c2"
support = 2.4                # radius of the kernel in particle spacings
correction = "gradient"
stabilization = [ { model = "hourglass_stiffness" } ]

[region]                     # sets of particles, by where they are at the beginning
clamp = { where = "X < spacing" }
tip = { nearest = ["length", "height/2"] }

[[initial]]
region = "beam"
velocity = ["0", "speed*(X/length)^2"]

[[boundary]]
region = "clamp"
velocity = [0, 0]

[solver]
end_time = 0.2
cfl = 0.3

[output]
every = "end_time/30"        # particle files for ParaView
history_every = "end_time/1000"
picture = "picture.png"

[[probe]]                    # one column in history.csv
name = "tip"
quantity = "displacement"
region = "tip"
component = "y"

# What should come out: `sinew run` prints it, `sinew verify` asserts it.
# [[expect]]
# quantity = "probe.tip.period"
# value = 0.1
# tolerance = 0.05

# The same for several values, in one go:
# [study]
# vary = { "parameters.n" = [4, 8, 16] }
)toml";

constexpr const char* pull = R"toml(# A strip of rubber is pulled to twice its length. Two dimensions, plane stress.

[case]
name = "pull"
dimension = 2
plane = "stress"
thickness = "2 mm"

[parameters]
n = 10                       # particles across the width
length = 0.1
width = 0.02
spacing = "width/n"
pull = "length"              # how far the right end moves
duration = 0.02

[[body]]
name = "strip"
geometry = { shape = "box", low = [0, 0], high = ["length", "width"], spacing = "spacing" }
material = { model = "neo_hookean", density = 1100, youngs_modulus = "17 MPa", poissons_ratio = 0.45 }

[formulation]
kernel = "wendland_c2"
support = 2.4
correction = "gradient"
stabilization = [ { model = "hourglass_stiffness" } ]

[region]
left = { where = "X < spacing" }
right = { where = "X > length - spacing" }

[[boundary]]
region = "left"
velocity = [0, 0]

[[boundary]]                 # a motion that starts and ends gently
region = "right"
displacement = ["pull*(1 - cos(pi*t/duration))/2", 0]

[solver]
end_time = "duration"

[output]
every = "end_time/40"
history_every = "end_time/500"
picture = "picture.png"
picture_field = "von_mises_stress"

[[probe]]
name = "extension"
quantity = "displacement"
region = "right"
component = "x"

[[probe]]                    # the force that the pull takes
name = "force"
quantity = "reaction_force"
region = "right"
reduce = "sum"
component = "x"
)toml";

constexpr const char* block3d = R"toml(# A column of rubber, held at its foot, is set twisting. Three dimensions.

[case]
name = "block3d"
dimension = 3

[parameters]
n = 6                        # particles across the width
omega = 40.0                 # initial rate of rotation at the top [rad/s]

[[body]]
name = "column"
geometry = { shape = "box", low = [-0.5, -0.5, 0], high = [0.5, 0.5, 3], spacing = "1/n" }
material = "rubber"

[material.rubber]
model = "neo_hookean"
density = 1100
youngs_modulus = "17 MPa"
poissons_ratio = 0.45

[formulation]
kernel = "wendland_c2"
support = 2.2
correction = "gradient"
stabilization = [ { model = "hourglass_stiffness" } ]

[region]
foot = { where = "Z < 1/n" }
top = { nearest = [0.5, 0.5, 3] }

[[initial]]
region = "column"
velocity = ["-omega*Y*sin(pi*Z/6)", "omega*X*sin(pi*Z/6)", 0]

[[boundary]]
region = "foot"
velocity = [0, 0, 0]

[solver]
end_time = 0.1

[output]
every = "end_time/20"
history_every = "end_time/200"
picture = "picture.png"

[[probe]]
name = "top"
quantity = "displacement"
region = "top"
component = "magnitude"
)toml";

}  // namespace

const std::vector<CaseTemplate>& case_templates() {
  static const std::vector<CaseTemplate> templates{{"beam", "a swinging beam, clamped at one end, in 2D", beam},
                                                   {"pull", "a strip of rubber, pulled to twice its length, in 2D", pull},
                                                   {"block3d", "a twisting column of rubber in 3D", block3d}};
  return templates;
}

}  // namespace sinew
