/// Writes the particle files that vtk_readers_test.py reads back: three frames with known numbers, one in single precision, and one without
/// particles.

#include <sinew/io/run_folder.hpp>
#include <sinew/io/write_vtk.hpp>

namespace {

/// Component c of a field at particle p in a frame.
double known_value(int frame, std::size_t p, int c) { return 1000.0 * frame + static_cast<double>(p) + 0.125 * c + 1.0 / 3.0; }

sinew::Snapshot make_snapshot(int frame, std::size_t count) {
  sinew::Snapshot s;
  s.time = 0.1 * frame;
  s.fields = {{"pressure", "Pa", 1, {}},
              {"velocity", "m/s", 3, {}},
              {"cauchy_stress", "Pa", 6, {}},
              {"deformation_gradient", "1", 9, {}}};
  for (std::size_t p = 0; p < count; ++p) {
    s.position.push_back({{known_value(frame, p, 0), known_value(frame, p, 1), known_value(frame, p, 2)}});
    s.size.push_back(0.1);
    s.body.push_back(static_cast<int>(p % 2));
    for (sinew::FieldData& field : s.fields)
      for (int c = 0; c < field.components; ++c) field.values.push_back(known_value(frame, p, c));
  }
  return s;
}

}  // namespace

int main(int, char** arguments) {
  const std::string folder = arguments[1];
  const sinew::RunFolder run = sinew::RunFolder::create(folder, false);
  sinew::PvdSeries series(run.series());
  for (int frame = 0; frame < 3; ++frame) {
    const std::size_t count = frame == 1 ? 70'000 : 5;  // many: several blocks of text
    sinew::write_vtu(run.frame(frame), make_snapshot(frame, count));
    series.add(0.1 * frame, sinew::RunFolder::frame_name(frame));
  }
  sinew::write_vtu(run.frame(98), make_snapshot(98, 70'000), sinew::VtkReal::float32);
  sinew::write_vtu(run.frame(99), make_snapshot(99, 0));
}
