// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sessions/people_names.h"

#include "database/repositories/account_repository.h"

namespace chiron::desktop {

core::Result<PeopleNames> PeopleNames::read(database::Connection& connection, const database::Actor& actor) {
    database::AccountRepository accounts(connection, actor);
    PeopleNames names;
    auto people = accounts.listPeople();
    if (!core::failedAs(people, core::ErrorCode::notAllowed))
        CHIRON_TRY(people);
    if (!people) {
        const auto self = accounts.person(actor.personId());
        if (!core::failedAs(self, core::ErrorCode::notAllowed))
            CHIRON_TRY(self);
        people = self ? std::vector<database::Person>{*self} : std::vector<database::Person>{};
    }
    for (const database::Person& person : *people)
        if (!person.displayName.empty())
            names.m_full.emplace(person.id, person.displayName);
    return names;
}

std::string PeopleNames::of(const database::SessionSummary& session) const {
    if (session.person == database::Actor::kSimulatedPerson)
        return tr("Scripted hand").toStdString();
    const auto full = m_full.find(session.person);
    return full == m_full.end() ? session.personName : full->second;
}

} // namespace chiron::desktop
