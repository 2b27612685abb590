/// What a table is of, in words: for messages, and for who finds a file.
///
/// Numbers are in the units asked for. Thread rule: pure functions. Not known here: its errors.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "keys/convention.hpp"
#include "table/contact_table.hpp"

namespace wrc {

/// The value of one of identity_keys: "460 mm", "near".
std::string text_of_key(const TableIdentity& identity, std::size_t key, Units units);

/// Profiles, keys, friction, units and axes, and how far it reaches, in the units of the table.
std::vector<std::string> lines_of(const ContactTable& table);

} // namespace wrc
