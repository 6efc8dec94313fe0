#pragma once
/// history.csv, and what is remembered of it for the summary and for [[expect]].

#include <map>
#include <optional>
#include <sinew/cli/expect.hpp>
#include <sinew/io/history.hpp>
#include <sinew/io/run_folder.hpp>
#include <sinew/model/simulation.hpp>
#include <string>
#include <vector>

namespace sinew {

/// Takes a sample when one is due: when a multiple of history_every is reached or passed; without history_every after every
/// `stride` steps. The stride is 1, in a case of many particles one for every 20 000 of them, until there are `most_rows` rows; then it
/// doubles and every second row is dropped, and so on. All ranks keep the rows, the first one writes them; what may write is collective.
class Recorder {
 public:
  static constexpr std::size_t most_rows = 10000;

  Recorder(const Case& c, Simulation& simulation, const RunFolder& folder, const Comm& comm);

  void begin();                                                   ///< a new file, with the state as it is as the first row
  void resume(const std::map<std::string, double>& saved);        ///< goes on with the file after the time of the simulation
  bool is_due(double time_before, double time, long step) const;  ///< whether that step is followed by a row
  void after_step(double time_before);                            ///< a row if one is due
  void at_end();                                                  ///< a row if the last one is older
  void flush();
  void save(std::map<std::string, double>& numbers) const;

  std::map<std::string, ProbeRecord> probes() const;
  /// Of the last sample: error of the energy balance over the largest of the energies and the work.
  double energy_drift() const { return drift; }
  const Momenta& initial_momenta() const { return initial; }

 private:
  void sample(double time_step);
  void thin();
  std::vector<double> row(double time_step);
  void read_rows();
  void share_rows();

  const Case& c;
  Simulation& simulation;
  Comm comm;
  std::string path;
  std::vector<HistoryColumn> columns;
  std::optional<HistoryFile> file;  ///< of the first rank
  std::vector<std::vector<double>> rows;
  std::vector<double> probe_min, probe_max;
  long stride;
  double drift = 0.0, last_time_step = 0.0;
  Momenta initial;
};

/// Error of the energy balance over the largest of the energies and the work; 0 if there are none.
double relative_balance_error(const Energies& energies);

}  // namespace sinew
