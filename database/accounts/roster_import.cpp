// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/roster_import.h"

#include "database/access/authorise.h"
#include "database/accounts/account_rules.h"
#include "database/accounts/account_service.h"
#include "database/accounts/generated_password.h"
#include "database/accounts/password_hasher.h"
#include "database/repositories/account_repository.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace chiron::database {
namespace {

using Kind = RosterStep::Kind;

/// `hadBefore`: the full name in the list is one that this person had before a change of name.
RosterStep stepOf(const UserCsvRow& row, const Person* present, RosterExisting existing, bool hadBefore) {
    RosterStep step{row.line, Kind::add, row.name, row.displayName, row.roles, row.password.empty(),
                    0,        {},        {}};
    if (present == nullptr) {
        return step;
    }
    const bool updates = existing == RosterExisting::update;
    step.person = present->id;
    step.name = present->name;
    step.makesPassword = false;
    step.displayNameBefore = present->displayName;
    step.rolesBefore = present->roles;
    // A full name that the list does not give is kept, and an old list does not undo a change of name.
    const bool old = updates && hadBefore && row.displayName != present->displayName;
    step.earlierDisplayName = old ? row.displayName : std::string();
    step.displayName = updates && !old && !row.displayName.empty() ? row.displayName : present->displayName;
    step.roles = updates ? row.roles : present->roles;
    const bool same = step.displayName == present->displayName && step.roles == present->roles;
    step.kind = !updates ? Kind::skip : same ? Kind::same : Kind::update;
    return step;
}

core::Result<KnownPeople> peopleFor(Database& database, const Actor& actor) {
    auto reader = database.openReader();
    CHIRON_TRY(reader);
    CHIRON_TRY(authorise(**reader, actor, Action::importPeople));
    AccountRepository accounts(**reader, actor);
    auto people = accounts.listPeople();
    auto earlier = accounts.listEarlierLogins();
    CHIRON_TRY(people);
    CHIRON_TRY(earlier);
    return KnownPeople{*std::move(people), *std::move(earlier)};
}

/// The person whom a login name means.
struct Meant {
    const Person* person = nullptr; ///< null: a new person, or ambiguous
    bool byEarlierName = false;
    const Person* before = nullptr; ///< who had the name before, if another person has it today
    bool several = false;           ///< several people had it before, and nobody has it today
};

class NameIndex {
public:
    explicit NameIndex(const KnownPeople& known) {
        std::map<PersonId, const Person*> byId;
        for (const Person& person : known.people) {
            m_today.emplace(nameKey(person.name), &person);
            byId.emplace(person.id, &person);
        }
        for (const EarlierLogin& login : known.earlier) {
            if (const auto person = byId.find(login.person); person != byId.end()) {
                addBefore(login, person->second);
            }
        }
    }

    Meant meant(const std::string& name) const {
        const auto today = m_today.find(nameKey(name));
        const auto before = m_before.find(nameKey(name));
        const bool anybodyBefore = before != m_before.end() && !before->second.empty();
        if (today != m_today.end()) {
            return {today->second, false, anybodyBefore ? before->second.front() : nullptr, false};
        }
        if (!anybodyBefore) {
            return {};
        }
        return before->second.size() > 1 ? Meant{nullptr, false, nullptr, true}
                                         : Meant{before->second.front(), true, nullptr, false};
    }

    /// Returns whether this was the person's full name before a change of name.
    bool hadFullName(const Person* person, const std::string& displayName) const {
        return person != nullptr && !displayName.empty() && m_fullNames.contains({person->id, displayName});
    }

private:
    void addBefore(const EarlierLogin& earlier, const Person* person) {
        m_fullNames.emplace(person->id, earlier.displayName);
        if (nameKey(earlier.name) == nameKey(person->name)) {
            return; // only the full name was changed
        }
        std::vector<const Person*>& had = m_before[nameKey(earlier.name)];
        if (std::find(had.begin(), had.end(), person) == had.end()) {
            had.push_back(person);
        }
    }

    std::map<std::string, const Person*> m_today;
    std::map<std::string, std::vector<const Person*>> m_before;
    std::set<std::pair<PersonId, std::string>> m_fullNames; ///< full names before a change of name
};

/// Changes a step so that its line does not change the person.
void leave(RosterStep& step, RosterStep::Doubt doubt) {
    step.kind = Kind::skip;
    step.doubt = doubt;
    step.makesPassword = false;
    step.earlierDisplayName.clear();
    if (step.person != 0) {
        step.displayName = step.displayNameBefore;
        step.roles = step.rolesBefore;
    }
}

/// Two lines may name the same person by different names. The line with the current name counts, otherwise
/// the first one with an earlier name.
void settleSamePerson(std::vector<RosterStep>& steps) {
    std::map<PersonId, int> lines;
    for (const bool earlier : {false, true}) {
        for (RosterStep& step : steps) {
            if (step.person == 0 || step.earlierName.empty() == earlier) {
                continue;
            }
            if (const auto [found, first] = lines.emplace(step.person, step.line); !first) {
                leave(step, RosterStep::Doubt::sameAsLine);
                step.otherLine = found->second;
            }
        }
    }
}

/// The data that the writer stores, and the outcome that is reported afterwards.
struct Prepared {
    std::vector<NewPerson> people;
    std::vector<PersonChange> changes;
    RosterOutcome outcome;
};

core::Result<void> prepareNew(Prepared& prepared, const RosterStep& step, const std::string& given,
                              const PasswordHasher& hasher) {
    const std::string password = given.empty() ? generatedPassword() : given;
    const auto hash = hasher.hash(password);
    CHIRON_TRY(hash);
    prepared.people.push_back({step.name, step.displayName, step.roles, *hash, true});
    prepared.outcome.added.push_back(
        {0, step.name, step.displayName, given.empty() ? password : std::string()});
    return {};
}

} // namespace

int RosterPlan::count(RosterStep::Kind kind) const {
    return static_cast<int>(std::count_if(steps.begin(), steps.end(),
                                          [kind](const RosterStep& step) { return step.kind == kind; }));
}

std::vector<RosterStep> planRoster(const Roster& roster, const KnownPeople& known, RosterExisting existing) {
    const NameIndex names(known);
    std::vector<RosterStep> steps;
    for (const UserCsvRow& row : roster.rows) {
        const Meant meant = names.meant(row.name);
        RosterStep& step = steps.emplace_back(
            stepOf(row, meant.person, existing, names.hadFullName(meant.person, row.displayName)));
        if (meant.byEarlierName) {
            step.earlierName = row.name;
        } else if (meant.several) {
            leave(step, RosterStep::Doubt::severalHadIt);
        } else if (meant.before != nullptr) {
            step.doubt = RosterStep::Doubt::nameOfAnother;
            step.other = meant.before->name;
        }
    }
    settleSamePerson(steps);
    return steps;
}

core::Result<RosterPlan> AccountService::previewCsv(const Actor& actor, const std::string& csv,
                                                    RosterExisting existing, const RoleWords& roles) {
    const auto people = peopleFor(m_database, actor);
    CHIRON_TRY(people);
    RosterPlan plan{readRoster(csv, roles), {}};
    plan.steps = planRoster(plan.roster, *people, existing);
    for (UserCsvRow& row : plan.roster.rows) {
        row.password.clear(); // the preview does not need it
    }
    return plan;
}

core::Result<RosterOutcome> AccountService::importCsv(const Actor& actor, const std::string& csv,
                                                      RosterExisting existing,
                                                      const std::function<bool(int done, int of)>& step,
                                                      const RoleWords& roles) {
    const Roster roster = readRoster(csv, roles);
    if (!roster.problems.empty()) {
        return tl::unexpected(rosterError(roster.problems));
    }
    const auto people = peopleFor(m_database, actor);
    CHIRON_TRY(people);
    const PasswordHasher hasher(m_database.options().passwordCost);
    const std::vector<RosterStep> steps = planRoster(roster, *people, existing);
    Prepared prepared;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (step && !step(static_cast<int>(i), static_cast<int>(steps.size()))) {
            return core::fail(core::ErrorCode::cancelled, "the import was stopped; nobody was added");
        }
        if (steps[i].kind == Kind::update) {
            prepared.changes.push_back({steps[i].person, steps[i].displayName, steps[i].roles});
        } else if (steps[i].kind == Kind::add) {
            CHIRON_TRY(prepareNew(prepared, steps[i], roster.rows[i].password, hasher));
        }
    }
    const auto ids = m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), actor).importPeople(prepared.people, prepared.changes);
    });
    CHIRON_TRY(ids);
    for (std::size_t i = 0; i < ids->size(); ++i) {
        prepared.outcome.added[i].id = (*ids)[i];
    }
    prepared.outcome.ignoredColumns = roster.ignoredColumns;
    std::copy_if(steps.begin(), steps.end(), std::back_inserter(prepared.outcome.told),
                 [](const RosterStep& each) {
                     return !each.earlierName.empty() || !each.earlierDisplayName.empty() ||
                            each.doubt != RosterStep::Doubt::none;
                 });
    prepared.outcome.updated = static_cast<int>(prepared.changes.size());
    prepared.outcome.skipped =
        static_cast<int>(steps.size() - prepared.people.size() - prepared.changes.size());
    return std::move(prepared.outcome);
}

} // namespace chiron::database
