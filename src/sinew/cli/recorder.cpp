#include <sinew/cli/recorder.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sinew/cli/schedule.hpp>
#include <sinew/io/file.hpp>

namespace sinew {

namespace {

constexpr std::size_t time_column = 0, step_column = 1;
constexpr long particles_a_step = 20000;  ///< a row reads all particles: with k times as many, one every k steps

std::vector<HistoryColumn> columns_of(const Case& c, const Simulation& simulation) {
  const UnitSystem& units = c.general.units;
  const std::string time = units.name_of("s"), energy = units.name_of("J");
  const std::string linear = units.name_of("kg m/s"), angular = units.name_of("kg m^2/s");
  std::vector<HistoryColumn> columns{{"time", time}, {"step", ""}, {"dt", time}};
  for (const char* name :
       {"kinetic", "strain", "hourglass", "contact", "total", "external_work", "dissipated", "plastic_work", "balance_error"})
    columns.push_back({std::string("energy.") + name, energy});
  for (const char* axis : {"x", "y", "z"}) columns.push_back({std::string("linear_momentum.") + axis, linear});
  for (const char* axis : {"x", "y", "z"}) columns.push_back({std::string("angular_momentum.") + axis, angular});
  const std::vector<std::string> probe_units = simulation.probe_units();
  for (std::size_t i = 0; i < c.probes.size(); ++i) columns.push_back({c.probes[i].name, probe_units[i]});
  return columns;
}

}  // namespace

double relative_balance_error(const Energies& e) {
  const double scale = std::max({std::abs(e.total()), std::abs(e.external_work), std::abs(e.initial), std::abs(e.dissipated)});
  return scale > 0.0 ? e.balance_error() / scale : 0.0;
}

Recorder::Recorder(const Case& case_, Simulation& simulation_, const RunFolder& folder, const Comm& comm_)
    : c(case_),
      simulation(simulation_),
      comm(comm_),
      path(folder.history()),
      columns(columns_of(case_, simulation_)),
      probe_min(case_.probes.size(), std::numeric_limits<double>::infinity()),
      probe_max(case_.probes.size(), -std::numeric_limits<double>::infinity()),
      stride(std::max(1L, static_cast<long>(simulation_.facts().particles) / particles_a_step)) {}

void Recorder::begin() {
  comm.on_root([&] { file.emplace(path, columns); });
  initial = simulation.momenta();
  sample(0.0);
}

bool Recorder::is_due(double time_before, double time, long step) const {
  return c.output.history_every > 0.0 ? multiple_reached(time_before, time, c.output.history_every) : step % stride == 0;
}

void Recorder::after_step(double time_before) {
  const double now = simulation.time();
  last_time_step = now - time_before;
  if (is_due(time_before, now, simulation.steps())) sample(last_time_step);
  if (c.output.history_every == 0.0 && rows.size() >= most_rows) thin();
}

void Recorder::at_end() {
  if (rows.empty() || rows.back()[time_column] < simulation.time()) sample(last_time_step);
}

void Recorder::flush() {
  comm.on_root([&] { file->flush(); });
}

std::vector<double> Recorder::row(double time_step) {
  const Energies e = simulation.energies();
  const Momenta m = simulation.momenta();
  drift = relative_balance_error(e);
  std::vector<double> values{simulation.time(), static_cast<double>(simulation.steps()),
                             time_step,         e.kinetic,
                             e.strain,          e.hourglass,
                             e.contact,         e.total(),
                             e.external_work,   e.dissipated,
                             e.plastic_work,    e.balance_error()};
  for (int i = 0; i < 3; ++i) values.push_back(m.linear[i]);
  for (int i = 0; i < 3; ++i) values.push_back(m.angular[i]);
  const std::vector<double> probes = simulation.probe_values();
  values.insert(values.end(), probes.begin(), probes.end());
  return values;
}

void Recorder::sample(double time_step) {
  rows.push_back(row(time_step));
  comm.on_root([&] { file->add_row(rows.back()); });
  const std::size_t first = columns.size() - c.probes.size();
  for (std::size_t i = 0; i < c.probes.size(); ++i) {
    probe_min[i] = std::min(probe_min[i], rows.back()[first + i]);
    probe_max[i] = std::max(probe_max[i], rows.back()[first + i]);
  }
}

void Recorder::thin() {
  stride *= 2;
  std::erase_if(rows, [&](const std::vector<double>& r) { return static_cast<long>(r[step_column]) % stride != 0; });
  comm.on_root([&] {
    file.emplace(path, columns);
    for (const std::vector<double>& r : rows) file->add_row(r);
    file->flush();
  });
}

std::map<std::string, ProbeRecord> Recorder::probes() const {
  std::map<std::string, ProbeRecord> records;
  const std::size_t first = columns.size() - c.probes.size();
  for (std::size_t i = 0; i < c.probes.size(); ++i) {
    ProbeRecord& record = records[c.probes[i].name];
    record.min = probe_min[i];
    record.max = probe_max[i];
    record.unit = columns[first + i].unit;
    for (const std::vector<double>& r : rows) {
      record.samples.time.push_back(r[time_column]);
      record.samples.value.push_back(r[first + i]);
    }
  }
  return records;
}

void Recorder::save(std::map<std::string, double>& numbers) const {
  numbers["history.stride"] = static_cast<double>(stride);
  for (int i = 0; i < 3; ++i) {
    numbers["history.linear." + std::to_string(i)] = initial.linear[i];
    numbers["history.angular." + std::to_string(i)] = initial.angular[i];
  }
  for (std::size_t i = 0; i < c.probes.size(); ++i) {
    numbers["history.min." + c.probes[i].name] = probe_min[i];
    numbers["history.max." + c.probes[i].name] = probe_max[i];
  }
}

void Recorder::resume(const std::map<std::string, double>& saved) {
  comm.on_root([&] {
    file.emplace(HistoryFile::resume(path, columns, simulation.time()));
    read_rows();
  });
  share_rows();
  stride = static_cast<long>(saved.at("history.stride"));
  for (int i = 0; i < 3; ++i) {
    initial.linear[i] = saved.at("history.linear." + std::to_string(i));
    initial.angular[i] = saved.at("history.angular." + std::to_string(i));
  }
  for (std::size_t i = 0; i < c.probes.size(); ++i) {
    probe_min[i] = saved.at("history.min." + c.probes[i].name);
    probe_max[i] = saved.at("history.max." + c.probes[i].name);
  }
}

/// From the first rank to all.
void Recorder::share_rows() {
  std::vector<double> values;
  for (const std::vector<double>& r : rows) values.insert(values.end(), r.begin(), r.end());
  comm.broadcast(values);
  rows.clear();
  for (auto next = values.begin(); next != values.end(); next += static_cast<std::ptrdiff_t>(columns.size()))
    rows.emplace_back(next, next + static_cast<std::ptrdiff_t>(columns.size()));
}

void Recorder::read_rows() {
  const std::string text = read_text(path);
  const char* const end = text.data() + text.size();
  const std::size_t header = text.find('\n');
  const char* next = header == std::string::npos ? end : text.data() + header + 1;
  while (next < end) {
    std::vector<double>& values = rows.emplace_back(columns.size());
    for (double& value : values)
      if (next < end) next = std::from_chars(next, end, value).ptr + 1;
  }
}

}  // namespace sinew
