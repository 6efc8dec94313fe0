#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sinew/core/error.hpp>
#include <sinew/io/file.hpp>
#include <sinew/io/summary.hpp>

namespace sinew {

namespace {

using Json = nlohmann::ordered_json;

/// The keys of each struct, once, for both directions.
template <class Visit>
void describe(ProbeSummary& s, Visit&& visit) {
  visit("final", s.final);
  visit("min", s.min);
  visit("max", s.max);
  visit("unit", s.unit);
}

template <class Visit>
void describe(ExpectSummary& s, Visit&& visit) {
  visit("quantity", s.quantity);
  visit("value", s.value);
  visit("published", s.published);
  visit("tolerance", s.tolerance);
  visit("absolute", s.absolute);
  visit("pass", s.pass);
  visit("why", s.why);
  visit("source", s.source);
  visit("note", s.note);
}

template <class Visit>
void describe(Summary& s, Visit&& visit) {
  visit("status", s.status);
  visit("message", s.message);
  visit("version", s.version);
  visit("commit", s.commit);
  visit("case", s.case_name);
  visit("particles", s.particles);
  visit("neighbors", s.neighbors);
  visit("steps", s.steps);
  visit("end_time", s.end_time);
  visit("wall_seconds", s.wall_seconds);
  visit("stepping_seconds", s.stepping_seconds);
  visit("particle_steps_per_second", s.particle_steps_per_second);
  visit("ranks", s.ranks);
  visit("threads", s.threads);
  visit("peak_memory_bytes", s.peak_memory_bytes);
  visit("state_hash", s.state_hash);
  visit("energy", s.energy);
  visit("momentum", s.momentum);
  visit("probes", s.probes);
  visit("expect", s.expect);
  visit("exchange", s.exchange);
  visit("equations", s.equations);
  visit("pass_timings", s.pass_timings);
  visit("warnings", s.warnings);
}

template <class T>
concept Described = requires(T& value) {
  describe(value, [](const char*, auto&) {});
};

template <class T>
Json encode(const T& value);

template <class T>
Json encode(const std::optional<T>& value) {
  return value ? encode(*value) : Json(nullptr);
}

template <class T>
Json encode(const std::vector<T>& values) {
  Json json = Json::array();
  for (const T& value : values) json.push_back(encode(value));
  return json;
}

template <class T>
Json encode(const std::map<std::string, T>& values) {
  Json json = Json::object();
  for (const auto& [name, value] : values) json[name] = encode(value);
  return json;
}

template <class T>
Json encode(const T& value) {
  if constexpr (Described<T>) {
    Json json = Json::object();
    T copy = value;
    describe(copy, [&](const char* key, const auto& member) { json[key] = encode(member); });
    return json;
  } else {
    return Json(value);
  }
}

template <class T>
void decode(const Json& json, T& value);

inline void decode(const Json& json, double& value) {
  value = json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

template <class T>
void decode(const Json& json, std::optional<T>& value) {
  if (json.is_null())
    value.reset();
  else
    decode(json, value.emplace());
}

template <class T>
void decode(const Json& json, std::vector<T>& values) {
  values.clear();
  for (const Json& item : json) decode(item, values.emplace_back());
}

template <class T>
void decode(const Json& json, std::map<std::string, T>& values) {
  values.clear();
  for (const auto& item : json.items()) decode(item.value(), values[item.key()]);
}

template <class T>
void decode(const Json& json, T& value) {
  if constexpr (Described<T>)
    describe(value, [&](const char* key, auto& member) {
      if (const auto found = json.find(key); found != json.end()) decode(*found, member);
    });
  else
    value = json.get<T>();
}

}  // namespace

std::string json_text(const Summary& summary) {
  return encode(summary).dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void write_summary(const std::string& path, const Summary& summary) { write_atomically(path, json_text(summary)); }

Summary read_summary(const std::string& path) {
  const std::string text = read_text(path);
  try {
    const Json json = Json::parse(text);
    if (!json.is_object() || !json.contains("status"))
      throw CaseError(path + " is not a summary of a run: it has no \"status\".");
    Summary summary;
    decode(json, summary);
    return summary;
  } catch (const Json::exception& error) {
    throw CaseError(path + " is not a summary of a run: " + error.what() + ".");
  }
}

}  // namespace sinew
