// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_site.h"
#include "unit/database/study_site.h"

#include "database/integrity/row_digest.h"
#include "database/integrity/verifier.h"

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// What the sixth version of the schema brought: answers that belong to a run, and the language of each. The
/// table of answers was made anew.
class TestVersion6 : public QObject {
    Q_OBJECT
private slots:
    void version5VerifiesAndOpens();
    void answersOfVersion5AreKept();
};

void TestVersion6::version5VerifiesAndOpens() {
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path()));
    auto steps = builtInMigrations();
    steps.resize(5);
    auto connection = Connection::open(f.path(), Connection::Mode::readWrite);
    REQUIRE(MigrationRunner(steps).migrate(**connection));
    connection->reset();
    QCOMPARE(numberIn(f.path(), "PRAGMA user_version"), std::int64_t{5});
    QVERIFY(verifyDatabase(f.path(), f.options).ok()); // as it is, without the new columns
    REQUIRE(f.reopen());
    QCOMPARE(f.database->schemaVersion(), MigrationRunner().newest());
    f.database.reset();
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

namespace {

/// The table as version 5 had it, with what is in it.
std::string tableOfVersion5() {
    for (const Migration& step : builtInMigrations()) {
        const std::size_t at =
            step.version == 3 ? step.sql.find("CREATE TABLE questionnaire_answer") : std::string::npos;
        if (at != std::string::npos) {
            const std::size_t end = step.sql.find("STRICT;", at) + 7;
            return "CREATE TABLE old" + step.sql.substr(at + 33, end - at - 33);
        }
    }
    return {};
}

} // namespace

void TestVersion6::answersOfVersion5AreKept() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto admin = f.administrator();
    const auto ruth = f.person(*admin, "ruth", {Role::researcher});
    REQUIRE(ruth);
    const auto made = makeStudies(*f.database, *ruth, "older");
    REQUIRE(made);
    const std::vector<QuestionnaireAnswer> given{{made->ready, "face", "real", 4.0, "", ""},
                                                 {made->running, "face", "remarks", {}, "weich", ""}};
    REQUIRE(f.database->write([&](WriteContext& w) {
        return StudyRepository(w.connection(), *ruth).storeQuestionnaireAnswers(given);
    }));
    f.database.reset();
    {
        auto connection =
            Connection::open(f.path(), Connection::Mode::readWrite); // back to what version 5 stored
        REQUIRE(
            (*connection)
                ->execute("BEGIN;" + tableOfVersion5() +
                          "INSERT INTO old SELECT id, participant_id, questionnaire, item, answer_json, "
                          "answer_hash, utc, digest FROM questionnaire_answer;"
                          "DROP TABLE questionnaire_answer; ALTER TABLE old RENAME TO questionnaire_answer;"
                          "CREATE TRIGGER questionnaire_answer_stays BEFORE DELETE ON questionnaire_answer "
                          "BEGIN SELECT RAISE(ABORT, 'answers are overwritten, never deleted'); END;"
                          "DROP TABLE session_decision; DROP INDEX session_by_attempt;" // later versions'
                          "PRAGMA user_version=5; COMMIT;"));
    }
    QVERIFY(verifyDatabase(f.path(), f.options)
                .ok()); // an answer without run and language has the digest that version 5 gave it
    const std::string digests = "SELECT group_concat(id || lower(hex(digest))) FROM (SELECT id, digest FROM "
                                "questionnaire_answer ORDER BY id)";
    const auto textIn = [&](const std::string& sql) {
        return selectText(**Connection::open(f.path(), Connection::Mode::readOnly), sql)->value_or("");
    };
    const std::string before = textIn(digests);
    QVERIFY(!before.empty());
    REQUIRE(f.reopen());
    QCOMPARE(textIn(digests), before);
    QVERIFY(QFile::exists(
        QString::fromStdString(f.path() + ".before-v" + std::to_string(MigrationRunner().newest()))));
    auto reader = f.database->openReader();
    const auto answers = StudyReader(**reader, *ruth).questionnaireAnswers(made->frozen);
    REQUIRE(answers);
    QCOMPARE(answers->size(), std::size_t{2});
    QVERIFY(answers->front().number == 4.0 && answers->back().text == "weich");
    for (const QuestionnaireAnswer& answer : *answers) {
        QVERIFY(answer.run == 0 && answer.language.empty() && !answer.withheld);
    }
    QCOMPARE(f.database
                 ->write([&](WriteContext& w) {
                     return StudyRepository(w.connection(), *ruth).storeQuestionnaireAnswers({given.front()});
                 })
                 .error()
                 .code,
             core::ErrorCode::wrongUse); // still once
    reader->reset();
    f.database.reset();
    QVERIFY(verifyDatabase(f.path(), f.options).ok()); // frozen designs against their SHA-256, too
}

QTEST_GUILESS_MAIN(TestVersion6)
#include "test_version_6.moc"
