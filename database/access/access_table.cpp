// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/access/access_table.h"

#include <algorithm>
#include <array>

namespace chiron::database {
namespace {

constexpr Scope No = Scope::none;
constexpr Scope Own = Scope::own;
constexpr Scope Sim = Scope::simulated;
constexpr Scope OwnSim = Scope::ownAndSimulated;
constexpr Scope All = Scope::all;
using A = Action;

// Who may do what. An action that is missing here is denied to everybody.
// clang-format off
constexpr AccessRow kRows[] = {
    // action                     anonymous simulated maintenance trainee trainer researcher admin
    {A::hasPeople,                All,      No,       No,         No,     No,     No,        No},
    {A::listLoginNames,           All,      No,       No,         No,     No,     No,        No},
    {A::createFirstAdministrator, All,      No,       No,         No,     No,     No,        No},
    {A::beginLogin,               All,      No,       No,         No,     No,     No,        No},
    {A::finishLogin,              All,      No,       No,         No,     No,     No,        No},
    {A::beginRecovery,            All,      No,       No,         No,     No,     No,        No},
    {A::finishRecovery,           All,      No,       No,         No,     No,     No,        No},
    {A::createPerson,             No,       No,       No,         No,     No,     No,        All},
    {A::importPeople,             No,       No,       No,         No,     No,     No,        All},
    {A::listPeople,               No,       No,       No,         No,     All,    No,        All},
    {A::person,                   No,       No,       No,         Own,    All,    Own,       All},
    {A::personByName,             No,       No,       No,         Own,    All,    Own,       All},
    {A::setEnabled,               No,       No,       No,         No,     No,     No,        All},
    {A::setRoles,                 No,       No,       No,         No,     No,     No,        All},
    {A::changeNames,              No,       No,       No,         No,     No,     No,        All},
    {A::changeDisplayName,        No,       No,       No,         Own,    Own,    Own,       Own},
    {A::earlierNames,             No,       No,       No,         Own,    All,    Own,       All},
    {A::listEarlierLogins,        No,       No,       No,         No,     No,     No,        All},
    {A::changePassword,           No,       No,       No,         Own,    Own,    Own,       Own},
    {A::resetPassword,            No,       No,       No,         No,     No,     No,        All},
    {A::hasRecoveryCode,          No,       No,       No,         No,     No,     No,        Own},
    {A::setRecoveryCode,          No,       No,       No,         No,     No,     No,        Own},
    {A::exportPerson,             No,       No,       No,         Own,    Own,    Own,       All},
    {A::erasePerson,              No,       No,       No,         No,     No,     No,        All},
    {A::listErasures,             No,       No,       No,         No,     No,     No,        All},
    {A::beginSession,             No,       Own,      No,         Own,    Own,    Own,       Own},
    {A::openSink,                 No,       Own,      All,        Own,    Own,    Own,       Own},
    {A::storeTrial,               No,       Own,      All,        Own,    Own,    Own,       Own},
    {A::storeEvents,              No,       Own,      All,        Own,    Own,    Own,       Own},
    {A::finishSession,            No,       Own,      All,        Own,    Own,    Own,       Own},
    {A::voidSession,              No,       No,       No,         No,     All,    No,        All},
    {A::reinstateSession,         No,       No,       No,         No,     All,    No,        All},
    {A::setArchived,              No,       No,       No,         No,     All,    No,        All},
    {A::addComment,               No,       No,       No,         Own,    All,    All,       All},
    {A::listSessions,             Sim,      Sim,      All,        OwnSim, All,    All,       All},
    {A::listUnfinished,           No,       No,       All,        No,     No,     No,        All},
    {A::session,                  Sim,      Sim,      All,        OwnSim, All,    All,       All},
    {A::trials,                   Sim,      Sim,      All,        OwnSim, All,    All,       All},
    {A::events,                   Sim,      Sim,      All,        OwnSim, All,    All,       All},
    {A::secondSummaries,          Sim,      Sim,      All,        OwnSim, All,    All,       All},
    {A::comments,                 Sim,      Sim,      No,         OwnSim, All,    All,       All},
    {A::commentedSessions,        No,       No,       No,         Own,    All,    All,       All},
    {A::openChunks,               Sim,      Sim,      All,        OwnSim, All,    All,       All},
    {A::storeScores,              No,       Own,      All,        Own,    Own,    Own,       Own},
    {A::scores,                   Sim,      Sim,      All,        OwnSim, All,    All,       All},
    {A::scoreSeal,                Sim,      Sim,      All,        OwnSim, All,    All,       All},
    {A::listAudit,                No,       No,       No,         No,     No,     No,        All},
    // A study, and everything in it, belongs to its author.
    {A::createStudy,          No,       Own,      No,         No,     No,     Own,       Own},
    {A::saveDraft,            No,       Own,      No,         No,     No,     Own,       All},
    {A::freezeStudy,          No,       Own,      No,         No,     No,     Own,       All},
    {A::closeStudy,           No,       Own,      No,         No,     No,     Own,       All},
    {A::setStudyArchived,     No,       Own,      No,         No,     No,     Own,       All},
    {A::unblindStudy,         No,       Own,      No,         No,     No,     Own,       All},
    {A::enrolParticipant,     No,       Own,      No,         No,     No,     All,       All},
    {A::enrolAccount,         No,       No,       No,         No,     No,     All,       All},
    {A::recordConsent,        No,       Own,      No,         No,     No,     All,       All},
    {A::completeParticipant,  No,       Own,      No,         No,     No,     All,       All},
    {A::withdrawParticipant,  No,       Own,      No,         No,     No,     All,       All},
    {A::conductRun,           No,       Own,      No,         No,     No,     All,       All},
    {A::beginRun,             No,       Own,      No,         No,     No,     All,       All},
    {A::storeStudyTrial,      No,       Own,      No,         No,     No,     All,       All},
    {A::finishRun,            No,       Own,      No,         No,     No,     All,       All},
    {A::storeQuestionnaireAnswers,No,       Own,      No,         No,     No,     All,       All},
    {A::listStudies,          Sim,      Sim,      No,         No,     No,     All,       All},
    {A::listPilots,           Sim,      Sim,      No,         No,     No,     All,       All},
    {A::study,                Sim,      Sim,      No,         No,     No,     All,       All},
    {A::studyByKey,           Sim,      Sim,      No,         No,     No,     All,       All},
    {A::conditionCodes,       Sim,      Sim,      No,         No,     No,     All,       All},
    {A::sealedConditions,     No,       Own,      No,         No,     No,     Own,       All},
    {A::participants,         Sim,      Sim,      No,         No,     No,     All,       All},
    {A::participantByCode,    Sim,      Sim,      No,         No,     No,     All,       All},
    {A::runs,                 Sim,      Sim,      No,         No,     No,     All,       All},
    {A::studyTrials,          Sim,      Sim,      No,         No,     No,     All,       All},
    {A::trialQuality,         Sim,      Sim,      No,         No,     No,     All,       All},
    {A::questionnaireAnswers, Sim,      Sim,      No,         No,     No,     All,       All},
    {A::participantKeys,      No,       No,       No,         No,     No,     Own,       All},
    {A::eraseParticipant,     No,       No,       No,         No,     No,     No,        All},
    {A::recordStationCheck,       No,       No,       No,         No,     No,     All,       All},
    {A::siteName,                 All,      All,      All,        All,    All,    All,       All},
    {A::setSiteName,              No,       No,       No,         No,     No,     No,        All},
    {A::backup,                   No,       No,       No,         No,     No,     No,        All},
    {A::backupStanding,           No,       No,       All,        No,     No,     No,        All},
    {A::setBackupPlan,            No,       No,       No,         No,     No,     No,        All},
    {A::dailyBackup,              No,       No,       All,        No,     No,     No,        No},
    {A::restore,                  No,       No,       No,         No,     No,     No,        All},
    {A::exportSite,               No,       No,       No,         No,     No,     No,        All},
};
// clang-format on

Scope widest(Scope a, Scope b) noexcept {
    if ((a == Scope::own && b == Scope::simulated) || (a == Scope::simulated && b == Scope::own)) {
        return Scope::ownAndSimulated;
    }
    return std::max(a, b);
}

Scope columnOf(const AccessRow& row, Role role) noexcept {
    switch (role) {
    case Role::trainee:
        return row.trainee;
    case Role::trainer:
        return row.trainer;
    case Role::researcher:
        return row.researcher;
    case Role::admin:
        return row.admin;
    }
    return Scope::none;
}

} // namespace

std::string_view token(Action action) noexcept {
    static constexpr std::array kNames{
#define CHIRON_NAME(class_, function) std::string_view(#function),
        CHIRON_REPOSITORY_FUNCTIONS(CHIRON_NAME)
#undef CHIRON_NAME
    };
    const auto index = static_cast<std::size_t>(action);
    return index < kNames.size() ? kNames[index] : std::string_view{};
}

std::optional<AccessRow> accessRow(Action action) noexcept {
    const auto* found = std::find_if(std::begin(kRows), std::end(kRows),
                                     [&](const AccessRow& r) { return r.action == action; });
    return found == std::end(kRows) ? std::nullopt : std::optional(*found);
}

Scope scopeOf(Action action, ActorKind kind, const RoleSet& roles) noexcept {
    const auto row = accessRow(action);
    if (!row) {
        return Scope::none;
    }
    switch (kind) {
    case ActorKind::anonymous:
        return row->anonymous;
    case ActorKind::simulated:
        return row->simulated;
    case ActorKind::maintenance:
        return row->maintenance;
    case ActorKind::person:
        break;
    }
    Scope scope = Scope::none;
    for (const Role role : kAllRoles) {
        scope = roles.contains(role) ? widest(scope, columnOf(*row, role)) : scope;
    }
    return scope;
}

} // namespace chiron::database
