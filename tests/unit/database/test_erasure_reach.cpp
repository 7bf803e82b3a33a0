// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_site.h"

#include "database/integrity/verifier.h"
#include "database/query.h"

#include <algorithm>
#include <map>
#include <set>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {

using Row = std::map<std::string, std::string>; ///< by column, as SQLite quotes it
using Rows = std::map<std::string, Row>;        ///< by "table rowid"

constexpr const char* kUnreadable = "cannot be read";

Rows everyRow(Connection& connection) {
    Rows rows;
    auto tables = Query::run(
        connection, "SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE 'sqlite_%'");
    while (tables && tables->next().value_or(false)) {
        const std::string table = tables->text(0);
        std::vector<std::string> columns;
        std::string list = "rowid";
        auto named = Query::run(connection, "SELECT name FROM pragma_table_info(?)", {table});
        while (named && named->next().value_or(false)) {
            columns.push_back(named->text(0));
            list += ", quote(" + columns.back() + ")";
        }
        auto read = Query::run(connection, "SELECT " + list + " FROM " + table);
        if (!read)
            rows[table + " " + kUnreadable];
        while (read && read->next().value_or(false)) {
            Row& row = rows[table + " " + std::to_string(read->integer(0))];
            for (std::size_t i = 0; i < columns.size(); ++i)
                row[columns[i]] = read->text(static_cast<int>(i) + 1);
        }
    }
    return rows;
}

/// Somebody with an account who also took part in a study, and all that is stored of that.
struct Someone {
    PersonId person = 0;
    ParticipantNumber participant = 0;
    StudyRunNumber run = 0;
    SessionId training = 0; ///< of the account's own
    SessionId sitting = 0;  ///< of the participant, recorded by the researcher
    SessionId left = 0;     ///< likewise, left before a trial was stored
};

} // namespace

/// Erases one of three people who have the same kinds of records, and checks that no row of the others
/// changes in any table.
class TestErasureReach : public QObject {
    Q_OBJECT
private slots:
    void onlyTheOneIsErased_data();
    void onlyTheOneIsErased();

private:
    core::Result<Someone> add(const std::string& name);
    std::string ofSomebodyElse(const std::string& place, const Row& before, const Row& after) const;

    std::unique_ptr<DatabaseFixture> m;
    Actor m_admin = Actor::anonymous();
    Actor m_ruth = Actor::anonymous();
    StudyNumber m_study = 0;
    Someone m_gone;
};

core::Result<Someone> TestErasureReach::add(const std::string& name) {
    Someone who;
    const auto actor = m->person(m_admin, name, {Role::trainee});
    const auto training = actor ? storeSession(*m->database, *actor, 2) : tl::unexpected(actor.error());
    CHIRON_TRY(training);
    who.person = actor->personId();
    who.training = *training;
    const auto begun = m->database->write([&](WriteContext& w) -> core::Result<void> {
        StudyRepository studies(w.connection(), m_ruth);
        const auto enrolled = studies.enrolParticipant(m_study, name + " of ward 3", who.person, "");
        CHIRON_TRY(enrolled);
        who.participant = enrolled->id;
        auto good = studies.recordConsent(who.participant, consentDigest());
        const auto run = studies.beginRun(
            {who.participant, codeOf(w.connection(), m_study, "soft"), 0, 1, "descending@1"});
        if (!good || !run)
            return good ? tl::unexpected(run.error()) : good;
        who.run = *run;
        return {};
    });
    NewSession setup = someSession();
    setup.studyRun = who.run;
    const auto left =
        begun ? storeSession(*m->database, m_ruth, 2, 700, setup) : tl::unexpected(begun.error());
    const auto sitting = left ? storeSession(*m->database, m_ruth, 2) : left;
    CHIRON_TRY(sitting);
    who.sitting = *sitting; // as earlier versions recorded it: known by its trial alone
    who.left = *left;
    const auto stored = m->database->write([&](WriteContext& w) -> core::Result<void> {
        StudyRepository studies(w.connection(), m_ruth);
        auto good = studies.storeStudyTrial(someTrial(who.run, 0, who.sitting));
        good = good ? studies.finishRun(who.run, StudyRunState::completed) : good;
        good = good ? studies.storeQuestionnaireAnswers(
                          {{who.participant, "face", "remarks", {}, "said by " + name, ""},
                           {who.participant, "face", "years", 41.0, "", ""}})
                    : good;
        for (const SessionId session : {who.training, who.sitting, who.left}) {
            SessionRepository sessions(w.connection(), m_admin);
            good = good ? drop(sessions.addComment(session, name + " trembled a little")) : good;
            good = good ? sessions.voidSession(session, name + " was called away") : good;
            good = good ? drop(ScoreRepository(w.connection(), Actor::maintenance())
                                   .storeScores(session, someCard()))
                        : good;
        }
        return good ? drop(SessionRepository(w.connection(), *actor)
                               .addComment(who.training, name + " says so, too"))
                    : good;
    });
    return stored ? core::Result<Someone>(who) : tl::unexpected(stored.error());
}

/// Empty where a changed row is the erased one's, or a note of the erasure.
std::string TestErasureReach::ofSomebodyElse(const std::string& place, const Row& before,
                                             const Row& after) const {
    const std::string table = place.substr(0, place.find(' '));
    if (before.empty() && (table == "audit" || table == "erasure" || table == "participant_erasure"))
        return {};
    const auto is = [&](const char* column, std::initializer_list<std::int64_t> ids) {
        const auto it = before.find(column);
        return it != before.end() && std::any_of(ids.begin(), ids.end(), [&](std::int64_t id) {
                   return it->second == std::to_string(id);
               });
    };
    if (is("participant_id", {m_gone.participant}) ||
        is("session_id", {m_gone.training, m_gone.sitting, m_gone.left}) ||
        is("person_id", {m_gone.person}) || is("run_id", {m_gone.run}))
        return {};
    if ((table == "participant_key" || table == "study_participant") && is("id", {m_gone.participant}))
        return {};
    if ((table == "session" && is("id", {m_gone.training, m_gone.sitting, m_gone.left})) ||
        (table == "person" && is("id", {m_gone.person})))
        return {};
    std::string words = place + ":";
    for (const auto& [column, value] : before.empty() ? after : before)
        if (before.empty() || after.empty() || after.at(column) != value)
            words += " " + column + " was " + (before.empty() ? "-" : value.substr(0, 40)) + ", is " +
                     (after.empty() ? "-" : after.at(column).substr(0, 40)) + ";";
    return words;
}

void TestErasureReach::onlyTheOneIsErased_data() {
    QTest::addColumn<bool>("person");
    QTest::addColumn<bool>("recordings");
    for (const bool person : {false, true})
        for (const bool recordings : {false, true})
            QTest::addRow("%s, recordings %s", person ? "person" : "participant", recordings ? "too" : "kept")
                << person << recordings;
}

void TestErasureReach::onlyTheOneIsErased() {
    QFETCH(bool, person);
    QFETCH(bool, recordings);
    m = std::make_unique<DatabaseFixture>();
    REQUIRE(m->create());
    m_admin = m->administrator().value();
    m_ruth = m->person(m_admin, "ruth", {Role::researcher}).value();
    REQUIRE(m->database->write([&](WriteContext& w) -> core::Result<void> {
        StudyRepository studies(w.connection(), m_ruth);
        const auto made = studies.createStudy("private", "Private", someDesign("private"));
        m_study = made.value_or(0);
        return made ? drop(studies.freezeStudy(m_study)) : drop(made);
    }));
    const auto before = add("ann");
    const auto gone = add("tim");
    const auto after = add("zoe");
    REQUIRE(before);
    REQUIRE(gone);
    REQUIRE(after);
    m_gone = *gone;
    if (!person)
        REQUIRE(m->database->write([&](WriteContext& w) {
            return StudyRepository(w.connection(), m_ruth)
                .withdrawParticipant(m_gone.participant, recordings);
        }));
    const Rows was = everyRow(**m->database->openReader());
    QVERIFY(was.size() > 60);
    for (const auto& [place, row] : was)
        QVERIFY2(!place.ends_with(kUnreadable), place.c_str());
    if (person)
        REQUIRE(
            AccountService(*m->database).erasePerson(m_admin, kPassword, m_gone.person, "wish", recordings));
    else
        REQUIRE(
            AccountService(*m->database).eraseParticipant(m_admin, kPassword, m_gone.participant, "wish"));
    const Rows is = everyRow(**m->database->openReader());
    std::set<std::string> changed;
    for (const auto& [place, row] : was)
        if (const auto now = is.find(place); now == is.end() || now->second != row)
            changed.insert(place);
    for (const auto& [place, row] : is)
        if (!was.contains(place))
            changed.insert(place);
    QVERIFY(changed.size() >= 5);
    for (const std::string& place : changed) {
        const std::string words = ofSomebodyElse(place, was.contains(place) ? was.at(place) : Row(),
                                                 is.contains(place) ? is.at(place) : Row());
        QVERIFY2(words.empty(), words.c_str());
    }
    for (const SessionId session : {m_gone.sitting, m_gone.left}) {
        const auto reader = m->database->openReader();
        QCOMPARE(selectInteger(**reader, "SELECT recording_erased FROM session WHERE id = ?", {session})
                     ->value_or(-1),
                 std::int64_t{recordings});
        QCOMPARE(selectInteger(**reader,
                               "SELECT count(*) FROM session_comment WHERE session_id = ? AND text <> ''",
                               {session})
                     ->value_or(-1),
                 std::int64_t{0});
        QCOMPARE(
            selectText(**reader, "SELECT void_reason FROM session WHERE id = ?", {session})->value_or("?"),
            std::string());
    }
    m->database.reset();
    const VerifyReport report = verifyDatabase(m->path(), m->options);
    QVERIFY2(report.ok(), report.findings.empty() ? "" : report.findings.front().detail.c_str());
}

QTEST_GUILESS_MAIN(TestErasureReach)
#include "test_erasure_reach.moc"
