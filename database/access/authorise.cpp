// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/access/authorise.h"

#include "database/query.h"

namespace chiron::database {
namespace {

// Turns an action into words for the message of a refusal: "listPeople" -> "list people", "scores" -> "read
// scores".
std::string wordsFor(Action action) {
    std::string words;
    for (const char c : token(action)) {
        const bool capital = c >= 'A' && c <= 'Z';
        words += capital ? std::string{' ', static_cast<char>(c - 'A' + 'a')} : std::string(1, c);
    }
    for (const char* thing :
         {"person", "earlier", "session", "trials", "events", "second", "comments", "score", "study",
          "sealed", "condition", "participant", "runs", "questionnaire"}) {
        if (words.starts_with(thing)) {
            return "read " + words;
        }
    }
    return words;
}

core::Error denied(const Actor& actor, Action action, const std::string& why) {
    const std::string who = actor.kind() == ActorKind::person      ? "for " + actor.name()
                            : actor.kind() == ActorKind::anonymous ? "without a login"
                            : actor.kind() == ActorKind::simulated ? "for the simulated account"
                                                                   : "for maintenance";
    return core::Error{core::ErrorCode::notAllowed,
                       "not allowed " + who + ": " + wordsFor(action) + " (" + why + ")"};
}

core::Result<Scope> scopeOfPerson(Connection& connection, const Actor& actor, Action action) {
    auto query = Query::run(
        connection,
        "SELECT p.roles, p.enabled, c.must_change FROM person p JOIN credential c ON c.person_id = p.id "
        "WHERE p.id = ? AND p.kind = 'person'",
        {actor.personId()});
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    if (!*row || query->integer(1) != 1) {
        return tl::unexpected(denied(actor, action, "the account is disabled; ask an administrator"));
    }
    if (query->integer(2) != 0 && action != Action::changePassword) {
        return tl::unexpected(denied(actor, action, "the password must be changed first"));
    }
    const auto roles = rolesFromList(query->text(0));
    return roles ? scopeOf(action, ActorKind::person, *roles) : Scope::none;
}

bool reaches(Scope scope, const Actor& actor, PersonId owner) {
    const bool own = actor.personId() != 0 && actor.personId() == owner;
    const bool simulated = owner == Actor::kSimulatedPerson;
    switch (scope) {
    case Scope::none:
        return false;
    case Scope::own:
        return own;
    case Scope::simulated:
        return simulated;
    case Scope::ownAndSimulated:
        return own || simulated;
    case Scope::all:
        return true;
    }
    return false;
}

} // namespace

core::Result<Scope> authorise(Connection& connection, const Actor& actor, Action action) {
    const auto scope = actor.kind() == ActorKind::person
                           ? scopeOfPerson(connection, actor, action)
                           : core::Result<Scope>(scopeOf(action, actor.kind(), {}));
    CHIRON_TRY(scope);
    if (*scope == Scope::none) {
        return tl::unexpected(denied(actor, action,
                                     actor.kind() == ActorKind::anonymous
                                         ? "log in first"
                                         : "the roles do not permit it; an administrator can change them"));
    }
    return scope;
}

core::Result<void> authoriseFor(Connection& connection, const Actor& actor, Action action, PersonId owner) {
    const auto scope = authorise(connection, actor, action);
    CHIRON_TRY(scope);
    if (!reaches(*scope, actor, owner)) {
        return tl::unexpected(denied(actor, action, "it belongs to somebody else"));
    }
    return {};
}

namespace {

/// An object that belongs to a person.
struct Owned {
    const char* what;
    std::int64_t number = 0;
    const char* ownerSql;
};

core::Result<void> authoriseForOwned(Connection& connection, const Actor& actor, Action action,
                                     const Owned& thing) {
    const auto scope = authorise(connection, actor, action);
    CHIRON_TRY(scope);
    const std::string name = thing.what + (" " + std::to_string(thing.number));
    const auto owner = selectInteger(connection, thing.ownerSql, {thing.number});
    CHIRON_TRY(owner);
    if (!*owner && *scope == Scope::all) {
        return core::fail(core::ErrorCode::notFound, "there is no " + name);
    }
    if (!*owner || !reaches(*scope, actor, **owner)) {
        return tl::unexpected(
            denied(actor, action,
                   name + (actor.kind() == ActorKind::anonymous ? " is not a simulated one; log in first"
                                                                : " is somebody else's")));
    }
    return {};
}

} // namespace

core::Result<void> authoriseForSession(Connection& connection, const Actor& actor, Action action,
                                       SessionId session) {
    return authoriseForOwned(connection, actor, action,
                             {"session", session, "SELECT person_id FROM session WHERE id = ?"});
}

core::Result<void> authoriseForStudy(Connection& connection, const Actor& actor, Action action,
                                     StudyPart part, std::int64_t number) {
    switch (part) {
    case StudyPart::study:
        return authoriseForOwned(connection, actor, action,
                                 {"study", number, "SELECT author_id FROM study WHERE id = ?"});
    case StudyPart::participant:
        return authoriseForOwned(
            connection, actor, action,
            {"participant", number,
             "SELECT s.author_id FROM study_participant p JOIN study s ON s.id = p.study_id "
             "WHERE p.id = ?"});
    case StudyPart::run:
        return authoriseForOwned(connection, actor, action,
                                 {"run", number,
                                  "SELECT s.author_id FROM study_run r JOIN study_participant p ON p.id = "
                                  "r.participant_id JOIN study s ON s.id = p.study_id WHERE r.id = ?"});
    }
    return tl::unexpected(denied(actor, action, "there is no such thing"));
}

} // namespace chiron::database
