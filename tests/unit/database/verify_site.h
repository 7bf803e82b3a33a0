// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/integrity/verifier.h"
#include "database/query.h"
#include "database_fixture.h"
#include "study_site.h"

#include <algorithm>

namespace chiron::test {

/// Whether verify told of this kind, table and (part of a) row.
inline bool has(const database::VerifyReport& report, const std::string& kind, const std::string& table,
                const std::string& row = {}) {
    return std::any_of(report.findings.begin(), report.findings.end(), [&](const database::Finding& f) {
        return f.kind == kind && f.table == table && f.row.find(row) != std::string::npos;
    });
}

/// Two studies: in the first one run is open and one (3 trials) has ended, one participant answered and one
/// is erased. The open run.
inline core::Result<database::StudyRunNumber> addStudies(DatabaseFixture& f, const database::Actor& ada) {
    using namespace database;
    const auto made = makeStudies(*f.database, ada, "site");
    CHIRON_TRY(made);
    auto done = f.database->write([&](WriteContext& w) -> core::Result<void> {
        StudyRepository studies(w.connection(), ada);
        const auto run = studies.beginRun(
            {made->ready, codeOf(w.connection(), made->frozen, "soft"), 0, 5, "descending@1"});
        auto good = run ? core::Result<void>() : tl::unexpected(run.error());
        for (int i = 0; good && i < 3; ++i) {
            good = studies.storeStudyTrial(someTrial(*run, i));
        }
        good = good ? studies.finishRun(*run, StudyRunState::completed) : good;
        return good ? studies.storeQuestionnaireAnswers(
                          {{made->ready, "face", "real", 4.0, "", ""},
                           {made->ready, "face", "remarks", {}, "soft as butter", ""}})
                    : good;
    });
    done =
        done ? AccountService(*f.database).eraseParticipant(ada, kPassword, made->withdrawn, "wish") : done;
    return done ? core::Result<StudyRunNumber>(made->run) : tl::unexpected(done.error());
}

/// A closed site with something in every table: three sessions (14 chunks, 12 scores), one commented and
/// voided for the second time, one person erased, studies.
inline core::Result<void> makeSite(DatabaseFixture& f) {
    using namespace database;
    auto done = f.create();
    const auto ada = done ? f.administrator() : core::Result<Actor>(tl::unexpected(done.error()));
    CHIRON_TRY(ada);
    const auto open = addStudies(f, *ada);
    CHIRON_TRY(open);
    NewSession sitting = someSession();
    sitting.studyRun = *open;
    const auto first = storeSession(*f.database, Actor::simulated(), 6, 9000);
    const auto second = storeSession(*f.database, *ada, 5, 5000, sitting);
    const auto third = storeSession(*f.database, Actor::simulated(), 3);
    if (!first || !second || !third) {
        return core::fail(core::ErrorCode::storage, "a session could not be stored");
    }
    done = f.database->write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository sessions(w.connection(), *ada);
        auto comment = sessions.addComment(*second, "steady hand");
        auto good = comment ? sessions.voidSession(*second, "the wrong chair")
                            : core::Result<void>(tl::unexpected(comment.error()));
        good = good ? sessions.reinstateSession(*second, "it was another chair") : good;
        return good ? sessions.voidSession(*second, "the chair fell over") : good;
    });
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    if (!done || !tim) {
        return done ? core::Result<void>(tl::unexpected(tim.error())) : done;
    }
    done = AccountService(*f.database).changeNames(*ada, tim->personId(), "timothy", "Timothy");
    done =
        done ? AccountService(*f.database).erasePerson(*ada, kPassword, tim->personId(), "wish", true) : done;
    f.database.reset(); // into one file
    return done;
}

/// A copy of the closed site with this done to it, past triggers and foreign keys; empty where that failed.
inline std::string damagedCopy(const DatabaseFixture& m, const std::string& sql) {
    using namespace database;
    const std::string copy = m.path("copy.db");
    QFile::remove(QString::fromStdString(copy));
    if (!QFile::copy(QString::fromStdString(m.path()), QString::fromStdString(copy))) {
        return {};
    }
    auto connection = Connection::create(copy);
    std::string open = "PRAGMA foreign_keys=OFF; PRAGMA synchronous=OFF; PRAGMA journal_mode=DELETE; ";
    if (connection) {
        const auto triggers = selectText(
            **connection,
            "SELECT group_concat('DROP TRIGGER ' || name, ';') FROM sqlite_schema WHERE type = 'trigger'");
        open += triggers ? triggers->value_or("") + ";" : "";
    }
    return connection && (*connection)->execute(open + sql) ? copy : std::string();
}

} // namespace chiron::test
