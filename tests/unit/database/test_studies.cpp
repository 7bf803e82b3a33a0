// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_people.h"

#include "database/integrity/verifier.h"
#include "database/query.h"

#include <QRegularExpression>
#include <set>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// Studies in the database: from draft to closed, participants, runs.
class TestStudies : public QObject, StudyPeople {
    Q_OBJECT
private slots:
    void init() { begin(); }
    void draftsChangeUntilFrozen();
    void frozenDesignCannotBeChangedByAnyWay();
    void auditKnowsTheFreezing();
    void keysAreOfPeopleAndOfTheSimulatedAccount();
    void codesAreRandomAndReadable();
    void ordersAreGivenOut();
    void keysAreReadByFewAndAudited();
    void simulatedAccountKeepsToItself();
    void pilotsAreListedByWhatTheyTry();
    void aBrokenJobLeavesNothing();
};

void TestStudies::draftsChangeUntilFrozen() {
    const auto study =
        write(m_ruth, [](StudyRepository& s) { return s.createStudy("soft_tubes", "Soft tubes", "{}"); });
    REQUIRE(study);
    QCOMPARE(write(m_ruth, [&](StudyRepository& s) { return s.freezeStudy(*study); }).error().code,
             core::ErrorCode::badInput);
    for (const char* wrong : {"", "[]", "{", "{\"a\":1}{}"}) {
        QCOMPARE(write(m_ruth, [&](StudyRepository& s) { return s.saveDraft(*study, wrong); }).error().code,
                 core::ErrorCode::badInput);
    }
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.saveDraft(*study, someDesign("soft_tubes")); }));
    const auto record = StudyReader(*reader(), m_ruth).study(*study);
    REQUIRE(record);
    QCOMPARE(record->summary.title, std::string("Stiffness of soft_tubes"));
    QVERIFY(record->summary.state == StudyState::draft && record->summary.sha256.empty());
    QCOMPARE(write(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(*study, "all are done"); })
                 .error()
                 .code,
             core::ErrorCode::wrongUse);
    const auto sha = write(m_ruth, [&](StudyRepository& s) { return s.freezeStudy(*study); });
    REQUIRE(sha);
    const auto after = StudyReader(*reader(), m_ruth).studyByKey("soft_tubes");
    REQUIRE(after);
    QCOMPARE(after->summary.sha256, *sha);
    QCOMPARE(catalogue::sha256Hex(after->designJson), *sha);
    QVERIFY(after->summary.state == StudyState::frozen && !after->summary.frozenUtc.empty());
    for (const auto& again :
         {write(m_ruth, [&](StudyRepository& s) { return s.saveDraft(*study, "{}"); }),
          write(m_ruth, [&](StudyRepository& s) { return drop(s.freezeStudy(*study)); })}) {
        QCOMPARE(again.error().code, core::ErrorCode::wrongUse);
    }
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.closeStudy(*study); }));
    QCOMPARE(
        write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(*study, "", 0, ""); }).error().code,
        core::ErrorCode::wrongUse);
    REQUIRE(write(m_admin, [&](StudyRepository& s) { return s.setStudyArchived(*study, true); }));
    QVERIFY(StudyReader(*reader(), m_ruth).listStudies()->empty());
    QCOMPARE(StudyReader(*reader(), m_ruth).listStudies(true)->front().state, StudyState::archived);
    REQUIRE(write(m_admin, [&](StudyRepository& s) { return s.setStudyArchived(*study, false); }));
    QCOMPARE(StudyReader(*reader(), m_ruth).study(*study)->summary.state, StudyState::closed);
}

void TestStudies::frozenDesignCannotBeChangedByAnyWay() {
    const StudyNumber study = frozen("fixed");
    QVERIFY(study != 0);
    for (const char* sql :
         {"UPDATE study SET design_json = '{}'", "UPDATE study SET sha256 = zeroblob(32)",
          "UPDATE study SET state = 'draft', sha256 = NULL", "UPDATE study SET key = 'other'",
          "UPDATE study SET title = 'other'", "DELETE FROM study",
          "UPDATE study_condition SET sealed_code = 'AAA' || ordinal", "DELETE FROM study_condition"}) {
        const auto done = m->database->write([&](WriteContext& w) { return w.connection().execute(sql); });
        QVERIFY2(!done && done.error().message.find("never") != std::string::npos, sql);
    }
}

void TestStudies::auditKnowsTheFreezing() {
    const StudyNumber study = frozen("noted");
    auto connection = reader();
    const auto detail = selectText(
        *connection, "SELECT detail_json FROM audit WHERE action = 'freezeStudy' AND target_id = ?", {study});
    const auto record = StudyReader(*connection, m_ruth).study(study);
    REQUIRE(record);
    QVERIFY((*detail)->find("\"sha256\":\"" + record->summary.sha256 + "\"") != std::string::npos);
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(study, "all are done"); }));
    QVERIFY(StudyReader(*reader(), m_ruth).study(study)->summary.unblinded);
    QCOMPARE(
        selectInteger(*reader(), "SELECT count(*) FROM audit WHERE action = 'unblindStudy'")->value_or(0),
        std::int64_t{1});
}

void TestStudies::keysAreOfPeopleAndOfTheSimulatedAccount() {
    const StudyNumber study = frozen("same_key");
    QCOMPARE(
        write(m_admin, [](StudyRepository& s) { return s.createStudy("same_key", "", "{}"); }).error().code,
        core::ErrorCode::badInput);
    const auto simulated =
        write(Actor::simulated(), [](StudyRepository& s) { return s.createStudy("same_key", "", "{}"); });
    REQUIRE(simulated);
    QCOMPARE(StudyReader(*reader(), m_ruth).studyByKey("same_key")->summary.id, study);
    QCOMPARE(StudyReader(*reader(), Actor::simulated()).studyByKey("same_key")->summary.id, *simulated);
    QCOMPARE(StudyReader(*reader(), m_ruth).studyByKey("none").error().code, core::ErrorCode::notFound);
    for (const char* key : {"", "Big", "1st", "a-b", "a b"}) {
        QCOMPARE(write(m_ruth, [&](StudyRepository& s) { return s.createStudy(key, "", "{}"); }).error().code,
                 core::ErrorCode::badInput);
    }
}

void TestStudies::codesAreRandomAndReadable() {
    const StudyNumber study = frozen("codes");
    static const QRegularExpression kCode(
        QStringLiteral("^[ACDEFGHJKMNPQRTWXY34679]{3}-[ACDEFGHJKMNPQRTWXY34679]{3}$"));
    std::set<std::string> codes;
    for (int i = 0; i < 60; ++i) {
        const auto who =
            write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(study, "somebody", 0, ""); });
        REQUIRE(who);
        QVERIFY2(kCode.match(QString::fromStdString(who->code)).hasMatch(), who->code.c_str());
        QVERIFY(codes.insert(who->code).second);
        QCOMPARE(who->order, i);
    }
    const std::string code = *codes.begin();
    QString lower = QString::fromStdString(code).toLower().remove('-');
    const auto found = StudyReader(*reader(), m_ruth).participantByCode(study, lower.toStdString());
    REQUIRE(found);
    QCOMPARE(found->code, code);
}

void TestStudies::ordersAreGivenOut() {
    const StudyNumber study = frozen("orders");
    const auto enrolled = [&](const std::string& observer, const std::string& code = "") {
        return write(m_ruth,
                     [&](StudyRepository& s) { return s.enrolParticipant(study, "", 0, observer, code); });
    };
    QCOMPARE(enrolled("")->order, 0);
    const auto second = enrolled("");
    QCOMPARE(second->order, 1);
    QCOMPARE(enrolled("weber:0.1", "P01")->order, 0); // simulated ones count by themselves
    QCOMPARE(enrolled("")->order, 2);
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.withdrawParticipant(second->id, false); }));
    QCOMPARE(enrolled("")->order, 1); // the row of who left
    QCOMPARE(enrolled("weber:0.1", "P01").error().code, core::ErrorCode::badInput);
    const StudyNumber beside = frozen("beside"); // a code is of its study
    REQUIRE(write(m_ruth,
                  [&](StudyRepository& s) { return s.enrolParticipant(beside, "", 0, "weber:0.2", "P01"); }));
    QCOMPARE(enrolled("", "P02").error().code, core::ErrorCode::badInput); // people get random codes
    QCOMPARE(StudyReader(*reader(), m_ruth).participantByCode(study, "p01")->observer,
             std::string("weber:0.1"));
    const auto twice = [&] {
        return write(m_ruth, [&](StudyRepository& s) {
            return s.enrolParticipant(study, "", m_admin.personId(), "");
        });
    };
    REQUIRE(twice());
    QCOMPARE(twice().error().code, core::ErrorCode::badInput);
}

void TestStudies::keysAreReadByFewAndAudited() {
    const StudyNumber study = frozen("keys");
    const auto who = write(m_ruth, [&](StudyRepository& s) {
        return s.enrolParticipant(study, "Jane Roe", m_admin.personId(), "");
    });
    REQUIRE(who);
    const auto other = m->person(m_admin, "rob", {Role::researcher});
    const auto look = [&](const Actor& actor) {
        return m->database->write(
            [&](WriteContext& w) { return StudyReader(w.connection(), actor).participantKeys(study); });
    };
    QCOMPARE(look(*other).error().code, core::ErrorCode::notAllowed);
    QCOMPARE(StudyReader(*reader(), m_ruth).participantKeys(study).error().code, core::ErrorCode::wrongUse);
    for (const Actor& actor : {m_ruth, m_admin}) {
        const auto keys = look(actor);
        REQUIRE(keys);
        QVERIFY(keys->front().identity == "Jane Roe" && keys->front().code == who->code &&
                keys->front().person == m_admin.personId());
    }
    QCOMPARE(
        selectInteger(*reader(), "SELECT count(*) FROM audit WHERE action = 'participantKeys'")->value_or(0),
        std::int64_t{2});
}

void TestStudies::simulatedAccountKeepsToItself() {
    const StudyNumber study = frozen("of_ruth");
    const auto made = makeStudies(*m->database, Actor::simulated(), "of_nobody");
    REQUIRE(made);
    auto connection = reader();
    StudyReader everybody(*connection, Actor::anonymous());
    QCOMPARE(everybody.listStudies()->size(), std::size_t{2});
    QCOMPARE(everybody.study(study).error().code, core::ErrorCode::notAllowed);
    QCOMPARE(everybody.studyByKey("of_ruth").error().code, core::ErrorCode::notFound);
    const auto participants = everybody.participants(made->frozen);
    for (const Participant& participant : *participants) {
        QVERIFY(participant.simulated && participant.enrolledBy == Actor::kSimulatedPerson);
    }
    QCOMPARE(write(Actor::simulated(),
                   [&](StudyRepository& s) { return s.enrolParticipant(study, "", 0, "weber:0.1"); })
                 .error()
                 .code,
             core::ErrorCode::notAllowed);
    QCOMPARE(write(Actor::simulated(),
                   [&](StudyRepository& s) { return s.enrolParticipant(made->frozen, "me", 0, ""); })
                 .error()
                 .code,
             core::ErrorCode::notAllowed);
}

// Pilots are listed under the key of the study that they try, and not among the studies. Without a login only
// those of the simulated account are visible.
void TestStudies::pilotsAreListedByWhatTheyTry() {
    const auto made = [&](const Actor& actor, const std::string& key, const std::string& of) {
        return write(actor, [&](StudyRepository& s) {
            return s.createStudy(key, key, of.empty() ? "{}" : R"({"pilot_of":")" + of + R"("})");
        });
    };
    for (const auto& [actor, name] :
         {std::pair{m_ruth, "ruth"}, std::pair{Actor::simulated(), "simulated"}}) {
        const std::string of = name;
        REQUIRE(made(actor, of + "_study", ""));
        REQUIRE(made(actor, of + "_pilot", "tried"));
        REQUIRE(made(actor, of + "_other", "untried"));
    }
    const auto connection = reader();
    const auto keys = [](const core::Result<std::vector<StudySummary>>& studies) {
        QStringList list;
        for (const StudySummary& study : studies.value_or(std::vector<StudySummary>{}))
            list << QString::fromStdString(study.key);
        return list;
    };
    StudyReader people(*connection, m_ruth), everybody(*connection, Actor::anonymous());
    QCOMPARE(keys(people.listPilots("tried")), (QStringList{"ruth_pilot", "simulated_pilot"}));
    QCOMPARE(keys(everybody.listPilots("tried")), QStringList{"simulated_pilot"});
    for (StudyReader* each : {&people, &everybody})
        QVERIFY(keys(each->listPilots("")).isEmpty() && keys(each->listPilots("nothing")).isEmpty());
    QCOMPARE(keys(people.listStudies()), (QStringList{"ruth_study", "simulated_study"}));
    QCOMPARE(keys(everybody.listStudies()), QStringList{"simulated_study"});
}

void TestStudies::aBrokenJobLeavesNothing() {
    const StudyNumber study = frozen("half");
    const auto broken = write(m_ruth, [&](StudyRepository& s) -> core::Result<void> {
        const auto who = s.enrolParticipant(study, "x", 0, "");
        return who ? s.recordConsent(who->id, "nonsense") : tl::unexpected(who.error());
    });
    QVERIFY(!broken);
    QVERIFY(StudyReader(*reader(), m_ruth).participants(study)->empty());
    m->database.reset();
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
}

QTEST_GUILESS_MAIN(TestStudies)
#include "test_studies.moc"
