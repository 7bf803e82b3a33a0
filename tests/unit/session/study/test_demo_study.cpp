// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/account_service.h"
#include "database/repositories/study_reader.h"
#include "psychophysics/observers/observer_spec.h"
#include "session/demo_study.h"
#include "support/session_fixture.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace chiron;

namespace {

constexpr const char* kPassword = "a long password for tests";

bool warns(const std::vector<psychophysics::Warning>& warnings, const std::string& token) {
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const psychophysics::Warning& each) { return warningToken(each.kind) == token; });
}

/// A site with a researcher and the demonstration's study.
struct Site {
    explicit Site(std::uint64_t seed, const std::atomic<bool>* cancel = nullptr) {
        database::AccountService accounts(*fixture.database);
        if (!accounts.createFirstAdministrator("ada", kPassword, "Ada"))
            qFatal("no administrator");
        const auto ada = accounts.login("ada", kPassword);
        if (!accounts.createPerson(
                *ada, {"rhea", "Rhea", database::RoleSet{database::Role::researcher}, kPassword, false}))
            qFatal("no researcher");
        rhea = *accounts.login("rhea", kPassword);
        made = session::makeDemoStudy(
            *fixture.database, rhea, seed, [&](const std::string& doing) { told.push_back(doing); }, cancel);
    }
    tests::SessionFixture fixture;
    database::Actor rhea = database::Actor::simulated();
    std::vector<std::string> told;
    core::Result<session::DemoStudy> made = core::fail(core::ErrorCode::notFound, "not yet");
};

} // namespace

/// What a researcher finds on a demonstration site.
class TestDemoStudy : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        qputenv("CHIRON_CONTENT", CHIRON_SOURCE_DIR "/curriculum/content");
        m_site = std::make_unique<Site>(1);
        QVERIFY2(m_site->made.has_value(), m_site->made ? "" : m_site->made.error().message.c_str());
    }
    void cleanupTestCase() { m_site.reset(); }
    void oneIsFrozenAndOneADraft();
    void everybodyIsSimulatedAndSaysSo();
    void quickRunsAreLabelled();
    void estimatesAreOfTheirObservers();
    void theRenderedSittingReplays();
    void sameSeedSameAnswers();
    void itStopsWhenAsked();

private:
    database::StudyReader reader() {
        m_connection = std::move(*m_site->fixture.database->openReader());
        return database::StudyReader(*m_connection, m_site->rhea);
    }
    std::unique_ptr<Site> m_site;
    std::unique_ptr<database::Connection> m_connection;
};

void TestDemoStudy::oneIsFrozenAndOneADraft() {
    const auto studies = reader().listStudies();
    QVERIFY(studies.has_value());
    QCOMPARE(studies->size(), std::size_t{2});
    const auto& [study, draft] = std::pair{studies->front(), studies->back()};
    QCOMPARE(study.id, m_site->made->study);
    QCOMPARE(study.state, database::StudyState::frozen);
    QCOMPARE(study.author, m_site->rhea.personId());
    QCOMPARE(study.participants, session::demoStudyParticipants());
    QCOMPARE(study.completed, session::demoStudyParticipants());
    QCOMPARE(draft.id, m_site->made->draft);
    QCOMPARE(draft.state, database::StudyState::draft);
    QCOMPARE(m_site->told.size(), static_cast<std::size_t>(session::demoStudyParticipants()));
}

void TestDemoStudy::everybodyIsSimulatedAndSaysSo() {
    const auto participants = reader().participants(m_site->made->study);
    QVERIFY(participants.has_value());
    for (const database::Participant& each : *participants) {
        QVERIFY2(each.simulated && !each.observer.empty() && each.code.rfind("SIM-", 0) == 0,
                 each.code.c_str());
        QVERIFY2(each.consentUtc.empty(), "nobody is there who could consent");
    }
    QVERIFY(warns(m_site->made->group.warnings, "simulated"));
    QVERIFY(warns(m_site->made->group.warnings, "not_rendered"));
}

void TestDemoStudy::quickRunsAreLabelled() {
    int rendered = 0;
    for (const session::DemoStudyRun& run : m_site->made->runs) {
        rendered += run.session != 0 ? 1 : 0;
        QCOMPARE(warns(run.estimate.warnings, "not_rendered"), run.session == 0);
    }
    QCOMPARE(rendered, 1);
    QCOMPARE(m_site->told.front(), std::string("study stiffness_elastic_tube, SIM-1, without rendering"));
    QCOMPARE(m_site->told.back(), std::string("study stiffness_elastic_tube, SIM-7"));
}

void TestDemoStudy::estimatesAreOfTheirObservers() {
    const session::DemoStudy& made = *m_site->made;
    QCOMPARE(made.runs.size(), static_cast<std::size_t>(session::demoStudyParticipants()));
    int inside = 0;
    for (const session::DemoStudyRun& run : made.runs) {
        const auto observer = psychophysics::parseObserver(run.observer);
        QVERIFY(observer.has_value());
        inside += run.estimate.weber95.low <= observer->weber && observer->weber <= run.estimate.weber95.high
                      ? 1
                      : 0;
        QVERIFY(run.estimate.trials >= 20 && run.choicesSame);
    }
    QVERIFY2(inside >= session::demoStudyParticipants() - 1, qPrintable(QString::number(inside)));
    QCOMPARE(made.group.participants, session::demoStudyParticipants());
    QVERIFY(made.group.weber95.low < 0.127 &&
            0.127 < made.group.weber95.high); // the observers' geometric mean
    QVERIFY(std::isfinite(made.group.jnd) && made.group.unit == "N/m");
}

void TestDemoStudy::theRenderedSittingReplays() {
    QVERIFY(m_site->made->replayIdentical);
}

void TestDemoStudy::sameSeedSameAnswers() {
    const Site again(1), other(2);
    QVERIFY(again.made.has_value() && other.made.has_value());
    bool differs = false;
    for (std::size_t i = 0; i < again.made->runs.size(); ++i) {
        QCOMPARE(again.made->runs[i].estimate.weber, m_site->made->runs[i].estimate.weber);
        QCOMPARE(again.made->runs[i].estimate.trials, m_site->made->runs[i].estimate.trials);
        differs = differs || other.made->runs[i].estimate.weber != again.made->runs[i].estimate.weber;
    }
    QVERIFY(differs);
}

void TestDemoStudy::itStopsWhenAsked() {
    const std::atomic<bool> cancel{true};
    const Site stopped(1, &cancel);
    QVERIFY(!stopped.made.has_value());
    QCOMPARE(stopped.made.error().code, core::ErrorCode::cancelled);
    QVERIFY(stopped.told.empty()); // no participant had begun
}

QTEST_GUILESS_MAIN(TestDemoStudy)
#include "test_demo_study.moc"
