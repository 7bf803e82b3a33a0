// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/role.h"

#include <cstdint>
#include <string>
#include <utility>

namespace chiron::database {

using PersonId = std::int64_t;
using SessionId = std::int64_t;

enum class ActorKind : std::uint8_t {
    anonymous, ///< without a login: may log in, and read simulated sessions
    simulated, ///< the built-in account of scripted operators
    /// The program itself: recovers sessions that a crash left open, and does nothing else.
    maintenance,
    person, ///< a person who logged in
};

/// On whose behalf something is done. A person's actor can only come from a login. Its rights are looked up
/// in the database at every call (roles, enabled, password to be changed), so that disabling an account takes
/// effect at once. A value type.
class Actor {
public:
    static Actor anonymous() { return Actor(ActorKind::anonymous, 0, {}, {}, false); }
    static Actor simulated() { return Actor(ActorKind::simulated, kSimulatedPerson, "simulated", {}, false); }
    static Actor maintenance() { return Actor(ActorKind::maintenance, 0, {}, {}, false); }

    ActorKind kind() const noexcept { return m_kind; }
    PersonId personId() const noexcept { return m_person; }             ///< 0 for anonymous and maintenance
    const std::string& name() const noexcept { return m_name; }         ///< the login name
    const std::string& fullName() const noexcept { return m_fullName; } ///< at login; empty if there is none
    const RoleSet& roles() const noexcept { return m_roles; } ///< as they were at login; for display only
    /// Until it is changed, only changePassword is permitted.
    bool mustChangePassword() const noexcept { return m_mustChange; }

    static constexpr PersonId kSimulatedPerson = 1; ///< id of a row that every new database has

private:
    friend class AccountRepository;
    Actor(ActorKind kind, PersonId person, std::string name, RoleSet roles, bool mustChange,
          std::string fullName = {})
        : m_kind(kind), m_person(person), m_name(std::move(name)), m_fullName(std::move(fullName)),
          m_roles(roles), m_mustChange(mustChange) {}

    ActorKind m_kind;
    PersonId m_person;
    std::string m_name;
    std::string m_fullName;
    RoleSet m_roles;
    bool m_mustChange;
};

} // namespace chiron::database
