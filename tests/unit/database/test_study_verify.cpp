// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify_site.h"

#include "database/integrity/digested_row.h"
#include "database/query.h"

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// verify: what it finds in studies, beside what it finds in every table (test_verify).
class TestStudyVerify : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { REQUIRE(makeSite(m)); }
    void studiesAreGuarded_data();
    void studiesAreGuarded();
    void studyChangedWithItsDigestIsFound();
    void whatFollowsTheFreezingIsSound();

private:
    DatabaseFixture m;
};

void TestStudyVerify::studiesAreGuarded_data() {
    QTest::addColumn<QString>("sql");
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("table");
    const auto row = [](const char* name, const char* sql, const char* kind, const char* table) {
        QTest::newRow(name) << sql << kind << table;
    };
    row("last trial", "DELETE FROM study_trial WHERE run_id = 2 AND ordinal = 2;", "missing", "study_trial");
    row("first trial", "DELETE FROM study_trial WHERE run_id = 2 AND ordinal = 0;", "seal", "study_run");
    row("gap in an open run", "UPDATE study_trial SET ordinal = 5 WHERE run_id = 1;", "missing",
        "study_trial");
    row("trial of another run", "UPDATE study_trial SET run_id = 1 WHERE run_id = 2 AND ordinal = 1;", "seal",
        "study_run");
    row("design", "UPDATE study SET design_json = replace(design_json, '0.05', '0.06') WHERE id = 2;",
        "study", "study");
    row("frozen study", "DELETE FROM study WHERE id = 2;", "missing", "study");
    row("sealed code", "DELETE FROM study_condition WHERE ordinal = 1;", "seal", "study");
    row("participant", "DELETE FROM study_participant WHERE id = 2;", "missing", "study_participant");
    row("key", "DELETE FROM participant_key WHERE id = 2;", "missing", "participant_key");
    row("key emptied", "UPDATE participant_key SET key_json = '' WHERE id = 2;", "payload",
        "participant_key");
    row("key changed",
        "UPDATE participant_key SET key_json = replace(key_json, 'Jane', 'Joan') WHERE id = 2;", "payload",
        "participant_key");
    row("consent", "DELETE FROM participant_consent WHERE id = 2;", "missing", "participant_consent");
    row("run", "DELETE FROM study_run WHERE id = 2;", "missing", "study_run");
    row("answer", "DELETE FROM questionnaire_answer WHERE id = 1;", "missing", "questionnaire_answer");
    row("answer changed",
        "UPDATE questionnaire_answer SET answer_json = replace(answer_json, '4', '5') WHERE id = 1;",
        "payload", "questionnaire_answer");
    row("tombstone", "DELETE FROM participant_erasure;", "missing", "participant_erasure");
}

void TestStudyVerify::studiesAreGuarded() {
    QFETCH(QString, sql);
    QFETCH(QString, kind);
    QFETCH(QString, table);
    DatabaseOptions options = m.options;
    options.siteFolder = m.path() + ".site";
    const std::string copy = damagedCopy(m, sql.toStdString());
    QVERIFY(!copy.empty());
    QVERIFY(has(verifyDatabase(copy, options), kind.toStdString(), table.toStdString()));
}

void TestStudyVerify::studyChangedWithItsDigestIsFound() {
    // Somebody without the site's key exchanges a frozen design with its SHA-256 and digest, a consent, a
    // code, a key, and a trial.
    const std::string copy = damagedCopy(m, "");
    QVERIFY(!copy.empty());
    {
        auto connection = Connection::create(copy);
        REQUIRE(connection);
        const std::string json = "{}";
        const QByteArray sha = QByteArray::fromHex(QByteArray::fromStdString(catalogue::sha256Hex(json)));
        REQUIRE(updateRow(**connection, "study", {{"id", std::int64_t{2}}},
                          {{"design_json", json}, {"sha256", Blob(sha.begin(), sha.end())}}));
        REQUIRE(updateRow(**connection, "participant_consent", {{"id", std::int64_t{2}}},
                          {{"recorded_by", std::int64_t{1}}}));
        REQUIRE(updateRow(**connection, "participant_key", {{"id", std::int64_t{2}}},
                          {{"key_hash", toBlob(textDigest("x"))}}));
        REQUIRE(updateRow(**connection, "study_condition",
                          {{"study_id", std::int64_t{2}}, {"ordinal", std::int64_t{0}}},
                          {{"sealed_code", std::string("AAA")}}));
        REQUIRE(updateRow(**connection, "study_trial",
                          {{"run_id", std::int64_t{2}}, {"ordinal", std::int64_t{2}}},
                          {{"answer", std::int64_t{0}}}));
    }
    DatabaseOptions options = m.options;
    options.siteFolder = m.path() + ".site";
    const VerifyReport report = verifyDatabase(copy, options);
    QVERIFY(has(report, "audit", "study", "id=2"));
    QVERIFY(has(report, "audit", "participant_consent", "id=2"));
    QVERIFY(has(report, "audit", "participant_key", "id=2"));
    QVERIFY(has(report, "seal", "study", "id=2"));
    QVERIFY(has(report, "seal", "study_run", "id=2"));
    QVERIFY(!has(report, "digest", "study_trial"));
}

// A frozen study is unblinded, closed and archived later: what the chain noted at its freezing still holds.
void TestStudyVerify::whatFollowsTheFreezingIsSound() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(ada);
    const auto made = makeStudies(*f.database, *ada, "later");
    REQUIRE(made);
    REQUIRE(f.database->write([&](WriteContext& w) -> core::Result<void> {
        StudyRepository studies(w.connection(), *ada);
        auto done = studies.unblindStudy(made->frozen, "all are done");
        done = done ? studies.closeStudy(made->frozen) : done;
        return done ? studies.setStudyArchived(made->frozen, true) : done;
    }));
    f.database.reset();
    const VerifyReport report = verifyDatabase(f.path(), f.options);
    QVERIFY2(report.ok(), report.ok() ? "" : report.findings.front().detail.c_str());
}

QTEST_GUILESS_MAIN(TestStudyVerify)
#include "test_study_verify.moc"
