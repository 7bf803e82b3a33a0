// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::database {

/// The role of a person; one person may have several. Stored as tokens (trainee, trainer, researcher, admin).
enum class Role : std::uint8_t { trainee, trainer, researcher, admin };

inline constexpr std::array<Role, 4> kAllRoles{Role::trainee, Role::trainer, Role::researcher, Role::admin};

/// Returns the stored word of a role.
std::string_view token(Role role) noexcept;
/// Returns the role of a stored word; none if there is no such role.
std::optional<Role> roleFromToken(std::string_view word) noexcept;

/// A set of roles. A value type.
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

/// Returns roles from "trainee,trainer" as on the command line and in CSV files; none if a word is unknown or
/// there is no word.
std::optional<RoleSet> rolesFromList(std::string_view commaSeparated);

} // namespace chiron::database
