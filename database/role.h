// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::database {

/// What a person may be; one person may hold several. Stored as tokens (trainee, trainer, researcher, admin).
enum class Role : std::uint8_t { trainee, trainer, researcher, admin };

inline constexpr std::array<Role, 4> kAllRoles{Role::trainee, Role::trainer, Role::researcher, Role::admin};

/// The stored word of a role.
std::string_view token(Role role) noexcept;
/// The role of a stored word; nothing if there is no such role.
std::optional<Role> roleFromToken(std::string_view word) noexcept;

/// A set of roles; a value.
class RoleSet {
public:
    RoleSet() = default;
    RoleSet(std::initializer_list<Role> roles) {
        for (const Role role : roles) {
            insert(role);
        }
    }
    void insert(Role role) noexcept { m_bits = static_cast<std::uint8_t>(m_bits | bit(role)); }
    bool contains(Role role) const noexcept { return (m_bits & bit(role)) != 0; }
    bool empty() const noexcept { return m_bits == 0; }
    bool operator==(const RoleSet&) const = default;
    std::vector<std::string> tokens() const; ///< in the order of kAllRoles
    std::string list() const;                ///< tokens joined by commas, as stored

private:
    static std::uint8_t bit(Role role) noexcept {
        return static_cast<std::uint8_t>(1u << static_cast<unsigned>(role));
    }
    std::uint8_t m_bits = 0;
};

/// Roles from "trainee,trainer" as the command line and CSV files write them; nothing if a word is unknown or
/// none is given.
std::optional<RoleSet> rolesFromList(std::string_view commaSeparated);

} // namespace chiron::database
