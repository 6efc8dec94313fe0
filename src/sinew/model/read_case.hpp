#pragma once
/// The parts of make_case: one function a section, run in this order, each filling in its part of the case.

#include <sinew/model/case.hpp>

namespace sinew {

/// What is being read and what has been understood so far.
struct CaseReader {
  const Node& root;
  Case result;
  Reading reading;
};

void read_general(CaseReader& reader);  ///< [case] and [parameters]
void read_materials_and_bodies(CaseReader& reader);
void read_formulation(CaseReader& reader);
void read_regions(CaseReader& reader);
void read_conditions(CaseReader& reader);  ///< [[initial]], [[boundary]], [body_force]
void read_contacts(CaseReader& reader);    ///< [[wall]]
void read_stages(CaseReader& reader);      ///< [[stage]]
void read_solver_and_output(CaseReader& reader);
void read_probes(CaseReader& reader);
void read_study_and_expects(CaseReader& reader);

/// The keys of a case file's top level.
const std::vector<std::string>& top_level_keys();

/// The table of a section, empty where the file has none.
Node section_table(const CaseReader& reader, const std::string& key);
/// The tables of [[key]]; none where the file has none.
std::vector<Node> section_entries(const CaseReader& reader, const std::string& key);
/// Adds a finished section to the resolved case, unless it is empty.
void add_resolved(CaseReader& reader, const std::string& key, Node value);
/// Sets or removes a key of a resolved table.
void set_member(Node& table, const std::string& key, Node value);
void erase_member(Node& table, const std::string& key);

/// CaseError unless the name is new and usable; `what` is "body", "region" or "probe".
void check_new_name(const std::string& name, const Place& place, const std::string& what, const std::vector<std::string>& taken);

/// Reads an entry of [[initial]], [[boundary]] or [[probe]]. Its region may be an inline table, which becomes a region of the case
/// called `owner`; the resolved entry keeps the table as it was given.
template <class T>
Node read_with_region(CaseReader& reader, T& object, const Node& entry, const std::string& owner);
/// Checks that `name` is a region, a body or "all".
void check_region(const CaseReader& reader, const std::string& name, const Place& place, const std::string& owner);
/// Adds an inline region to the case.
void add_inline_region(CaseReader& reader, const Node& table, const std::string& name);

template <class T>
Node read_with_region(CaseReader& reader, T& object, const Node& entry, const std::string& owner) {
  Node table = entry;
  Node* region = table.find("region");
  const bool is_inline = region && region->is(Node::Kind::table);
  if (is_inline) {
    add_inline_region(reader, *region, owner);
    *region = Node::make_string(owner, region->place);
  }
  Node resolved = read_described(object, table, owner, reader.reading);
  object.place = entry.place;
  if (is_inline) set_member(resolved, "region", *entry.find("region"));
  if (region && !is_inline) check_region(reader, object.region, region->place, owner);
  return resolved;
}

}  // namespace sinew
