// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/role.h"

namespace chiron::database {

std::string_view token(Role role) noexcept {
    switch (role) {
    case Role::trainee:
        return "trainee";
    case Role::trainer:
        return "trainer";
    case Role::researcher:
        return "researcher";
    case Role::admin:
        return "admin";
    }
    return {};
}

std::optional<Role> roleFromToken(std::string_view word) noexcept {
    for (const Role role : kAllRoles) {
        if (token(role) == word) {
            return role;
        }
    }
    return std::nullopt;
}

std::vector<std::string> RoleSet::tokens() const {
    std::vector<std::string> words;
    for (const Role role : kAllRoles) {
        if (contains(role)) {
            words.emplace_back(token(role));
        }
    }
    return words;
}

std::string RoleSet::list() const {
    std::string text;
    for (const std::string& word : tokens()) {
        text += text.empty() ? word : "," + word;
    }
    return text;
}

std::optional<RoleSet> rolesFromList(std::string_view list) {
    RoleSet roles;
    while (!list.empty()) {
        const std::size_t comma = list.find(',');
        const auto role = roleFromToken(list.substr(0, comma));
        if (!role) {
            return std::nullopt;
        }
        roles.insert(*role);
        list = comma == std::string_view::npos ? std::string_view{} : list.substr(comma + 1);
    }
    return roles.empty() ? std::nullopt : std::optional(roles);
}

} // namespace chiron::database
