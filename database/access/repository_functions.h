// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Every public function of the repositories and of storage upkeep: X(class, function). The list makes the
/// Action enumeration; access_table.cpp gives each a row of who may call it. A function without a row is
/// denied to everybody and fails a test, as does a public function in repositories/ or upkeep/ that is not
/// listed here.
#define CHIRON_REPOSITORY_FUNCTIONS(X)                                                                       \
    X(AccountRepository, hasPeople)                                                                          \
    X(AccountRepository, listLoginNames)                                                                     \
    X(AccountRepository, createFirstAdministrator)                                                           \
    X(AccountRepository, beginLogin)                                                                         \
    X(AccountRepository, finishLogin)                                                                        \
    X(AccountRepository, beginRecovery)                                                                      \
    X(AccountRepository, finishRecovery)                                                                     \
    X(AccountRepository, createPerson)                                                                       \
    X(AccountRepository, importPeople)                                                                       \
    X(AccountRepository, listPeople)                                                                         \
    X(AccountRepository, person)                                                                             \
    X(AccountRepository, personByName)                                                                       \
    X(AccountRepository, setEnabled)                                                                         \
    X(AccountRepository, setRoles)                                                                           \
    X(AccountRepository, changePassword)                                                                     \
    X(AccountRepository, resetPassword)                                                                      \
    X(PrivacyRepository, exportPerson)                                                                       \
    X(PrivacyRepository, erasePerson)                                                                        \
    X(PrivacyRepository, listErasures)                                                                       \
    X(SessionRepository, beginSession)                                                                       \
    X(SessionRepository, openSink)                                                                           \
    X(SessionRepository, storeTrial)                                                                         \
    X(SessionRepository, storeEvents)                                                                        \
    X(SessionRepository, finishSession)                                                                      \
    X(SessionRepository, voidSession)                                                                        \
    X(SessionRepository, setArchived)                                                                        \
    X(SessionRepository, addComment)                                                                         \
    X(SessionReader, listSessions)                                                                           \
    X(SessionReader, listUnfinished)                                                                         \
    X(SessionReader, session)                                                                                \
    X(SessionReader, trials)                                                                                 \
    X(SessionReader, events)                                                                                 \
    X(SessionReader, secondSummaries)                                                                        \
    X(SessionReader, comments)                                                                               \
    X(SessionReader, openChunks)                                                                             \
    X(ScoreRepository, storeScores)                                                                          \
    X(ScoreRepository, scores)                                                                               \
    X(AuditRepository, listAudit)                                                                            \
    X(Upkeep, backup)                                                                                        \
    X(Upkeep, restore)                                                                                       \
    X(Upkeep, exportSite)
