// SPDX-License-Identifier: GPL-3.0-or-later
// A draft that somebody tries: a marked copy that is in no list, no run and no analysis of the study; and
// what a participant meets, read off a design.
#include "catalogue/study_json.h"
#include "database/accounts/account_service.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "session/study/participant_view.h"
#include "session/study/pilot_run.h"
#include "session/study/study_store.h"
#include "support/session_fixture.h"
#include "support/study_designs.h"

#include <QtTest>

using namespace chiron;

namespace {

constexpr const char* kPassword = "a long password for tests";

struct Site {
    Site() {
        database::AccountService accounts(*fixture.database);
        if (!accounts.createFirstAdministrator("ada", kPassword, "Ada"))
            qFatal("no administrator");
        const auto ada = accounts.login("ada", kPassword);
        if (!ada ||
            !accounts.createPerson(
                *ada, {"rhea", "Rhea", database::RoleSet{database::Role::researcher}, kPassword, false}))
            qFatal("no researcher");
        actor = *accounts.login("rhea", kPassword);
    }
    template <class Job> auto write(Job job) {
        return fixture.database->write([&](database::WriteContext& context) {
            database::StudyRepository studies(context.connection(), actor);
            return job(studies);
        });
    }
    template <class Job> auto read(Job job) {
        auto connection = fixture.database->openReader();
        if (!connection)
            qFatal("%s", connection.error().message.c_str());
        database::StudyReader reader(**connection, actor);
        return job(reader);
    }
    database::StudyNumber draft(const psychophysics::StudyDesign& design) {
        return *write([&](database::StudyRepository& studies) {
            return studies.createStudy(design.id, design.title.at("en"),
                                       catalogue::studyJson(design).toStdString());
        });
    }

    tests::SessionFixture fixture;
    database::Actor actor = database::Actor::anonymous();
};

} // namespace

class TestPilotRun : public QObject {
    Q_OBJECT
private slots:
    void aPilotIsAMarkedCopy();
    void titlesSayItInTheirLanguage();
    void noListHoldsIt();
    void whatWasPilotedStaysAsItWas();
    void aFaultyDraftIsNotTried();
    void olderDesignsKeepTheirBytes();
    void whatAParticipantMeets();
};

void TestPilotRun::aPilotIsAMarkedCopy() {
    Site site;
    psychophysics::StudyDesign design = testing::rank3Study();
    design.blindExperimenter = false;
    site.draft(design);
    const auto pilot = session::beginPilot(*site.fixture.database, site.actor, design, "R. H.", "en");
    QVERIFY2(pilot, pilot ? "" : pilot.error().message.c_str());
    const auto record = site.read([&](database::StudyReader& reader) { return reader.study(pilot->study); });
    QVERIFY(record);
    QCOMPARE(record->summary.state, database::StudyState::frozen);
    QCOMPARE(record->summary.pilotOf, design.id);
    QVERIFY(record->summary.title.starts_with("Pilot: "));
    const auto copy = catalogue::readStudy(QByteArray::fromStdString(record->designJson), "pilot");
    QVERIFY(copy);
    QCOMPARE(copy->pilotOf, design.id); // in what is frozen and exported: nobody can take the mark off
    QCOMPARE(copy->conditions.size(), design.conditions.size());
    QVERIFY(copy->trial.exploreLimit_s == design.trial.exploreLimit_s && copy->seed == design.seed);
    // Whoever tries it has agreed, and the sitting that the window begins is allowed.
    const auto opened =
        session::openStudy(*site.fixture.database, site.actor, pilot->study, pilot->participantCode);
    QVERIFY2(opened, opened ? "" : opened.error().message.c_str());
    QCOMPARE(opened->participant.state, database::ParticipantState::consented);
    const auto run =
        session::conduct(*site.fixture.database, site.actor, *opened, design.conditions.front().id);
    QVERIFY2(run, run ? "" : run.error().message.c_str());
}

/// A title in a language that the program does not have says it in English.
void TestPilotRun::titlesSayItInTheirLanguage() {
    psychophysics::StudyDesign design = testing::rank3Study();
    design.title = {{"en", "Tubes"}, {"de", "Schläuche"}, {"el", "Σωλήνες"}, {"xx", "Xyz"}};
    const psychophysics::StudyDesign pilot = session::pilotDesign(design, "tubes_pilot_1");
    QCOMPARE(pilot.title.at("en"), std::string("Pilot: Tubes"));
    QCOMPARE(pilot.title.at("de"), std::string("Probelauf: Schläuche"));
    QCOMPARE(pilot.title.at("el"), std::string("Πιλοτική δοκιμή: Σωλήνες"));
    QCOMPARE(pilot.title.at("xx"), std::string("Pilot: Xyz"));
}

void TestPilotRun::noListHoldsIt() {
    Site site;
    const psychophysics::StudyDesign design = testing::rank3Study();
    const database::StudyNumber draft = site.draft(design);
    for (int n = 0; n < 2; ++n)
        QVERIFY(session::beginPilot(*site.fixture.database, site.actor, design, {}, "de"));
    for (const bool archived : {false, true}) {
        const auto list =
            site.read([&](database::StudyReader& reader) { return reader.listStudies(archived); });
        QVERIFY(list);
        QCOMPARE(list->size(), std::size_t{1});
        QCOMPARE(list->front().id, draft);
        QVERIFY(list->front().pilotOf.empty());
        QCOMPARE(list->front().participants, 0); // who tries it is no participant of the study
    }
    const auto pilots =
        site.read([&](database::StudyReader& reader) { return reader.listPilots(design.id); });
    QVERIFY(pilots);
    QCOMPARE(pilots->size(), std::size_t{2});
    QVERIFY(pilots->front().key != pilots->back().key);
    const auto others =
        site.read([](database::StudyReader& reader) { return reader.listPilots("another_study"); });
    QVERIFY(others && others->empty());
    const auto none = site.read([](database::StudyReader& reader) {
        return reader.listPilots("");
    }); // an empty key is not the mark of what is no pilot
    QVERIFY(none && none->empty());
    const auto participants =
        site.read([&](database::StudyReader& reader) { return reader.participants(draft); });
    QVERIFY(participants && participants->empty());
}

void TestPilotRun::whatWasPilotedStaysAsItWas() {
    Site site;
    psychophysics::StudyDesign design = testing::rank3Study();
    const database::StudyNumber draft = site.draft(design);
    const auto pilot = session::beginPilot(*site.fixture.database, site.actor, design, {}, "en");
    QVERIFY(pilot);
    design.trial.feedback = !design.trial.feedback;
    QVERIFY(site.write([&](database::StudyRepository& studies) {
        return studies.saveDraft(draft, catalogue::studyJson(design).toStdString());
    })); // still a draft
    const auto record = site.read([&](database::StudyReader& reader) { return reader.study(pilot->study); });
    const auto tried = catalogue::readStudy(QByteArray::fromStdString(record->designJson), "pilot");
    QVERIFY(tried && tried->trial.feedback != design.trial.feedback);
    QVERIFY(!site.write([&](database::StudyRepository& studies) {
        return studies.saveDraft(pilot->study, catalogue::studyJson(design).toStdString());
    }));
    const auto sha =
        site.write([&](database::StudyRepository& studies) { return studies.freezeStudy(draft); });
    QVERIFY2(sha, sha ? "" : sha.error().message.c_str());
    QCOMPARE(*sha, catalogue::studySha256(catalogue::studyJson(design))); // the pilot left no trace in it
}

void TestPilotRun::aFaultyDraftIsNotTried() {
    Site site;
    psychophysics::StudyDesign design = testing::rank3Study();
    site.draft(design);
    design.conditions.front().stimulus.reference = -1.0;
    const auto pilot = session::beginPilot(*site.fixture.database, site.actor, design, {}, "en");
    QVERIFY(!pilot);
    QCOMPARE(pilot.error().code, core::ErrorCode::badInput);
    const auto pilots =
        site.read([&](database::StudyReader& reader) { return reader.listPilots(design.id); });
    QVERIFY(pilots && pilots->empty()); // nothing is left half made
}

/// What was frozen before designs had a source, an approval and sentences made from the settings still has
/// its SHA-256.
void TestPilotRun::olderDesignsKeepTheirBytes() {
    const psychophysics::StudyDesign design = testing::rank3Study();
    const QByteArray json = catalogue::studyJson(design);
    for (const char* key : {"own_instructions", "\"source\"", "ethics", "pilot_of"})
        QVERIFY2(!json.contains(key), key);
    const auto read = catalogue::readStudy(json, "older");
    QVERIFY(read && !read->ownInstructions && read->source.empty() && read->ethics.empty() &&
            read->pilotOf.empty());
    QCOMPARE(catalogue::studyJson(*read), json);
    psychophysics::StudyDesign full = design;
    full.source = "Somebody (2020), doi:10.1000/1";
    full.ethics = "Committee of X, 17/2026";
    full.ownInstructions = psychophysics::StudyText{{"en", "Hold it lightly."}};
    full.pilotOf = "tubes";
    const QByteArray written = catalogue::studyJson(full);
    const auto again = catalogue::readStudy(written, "full");
    QVERIFY2(again, again ? "" : again.error().message.c_str());
    QCOMPARE(catalogue::studyJson(*again), written);
    QCOMPARE(again->ownInstructions->at("en"), std::string("Hold it lightly."));
    full.ownInstructions =
        psychophysics::StudyText{}; // no sentence of one's own is something else than an older design
    const auto empty = catalogue::readStudy(catalogue::studyJson(full), "empty");
    QVERIFY(empty && empty->ownInstructions && empty->ownInstructions->empty());
}

void TestPilotRun::whatAParticipantMeets() {
    psychophysics::StudyDesign design = testing::rank3Study();
    psychophysics::Condition& condition = design.conditions.front();
    condition.procedures = {psychophysics::ConstantSpec{
        {condition.stimulus.differences.front(), condition.stimulus.differences.back()}, 50, true}};
    design.trial = {};
    session::ParticipantView view = session::participantView(design);
    QCOMPARE(view.parts.size(), std::size_t{1});
    QCOMPARE(view.parts.front().trialsAtMost, 100);
    QVERIFY(view.parts.front().trialsFixed);
    QCOMPARE(view.parts.front().breaksAtMost, 2); // after 40 and 80
    QCOMPARE(view.parts.front().practice, 4);
    QCOMPARE(view.answer_s, 20.0);
    // 104 trials of three objects at 4 s, an answer at 2 s and a second between, and two breaks of 30 s.
    QVERIFY(std::abs(view.minutes() - (104 * 15.0 + 60.0) / 60.0) < 1e-9);
    design.trial.exploreLimit_s = 0.0; // the clock for answers starts when that for exploring has run out
    QCOMPARE(session::participantView(design).answer_s, 0.0);
    design.trial.breakEvery = 100; // the last trial needs no break
    QVERIFY(!session::participantView(design).anyBreak());
    psychophysics::StaircaseSpec endless;
    endless.stop = {.reversals = 12};
    condition.task = psychophysics::Task::twoAfc;
    condition.procedures = {endless};
    view = session::participantView(design);
    QCOMPARE(view.parts.front().trialsAtMost, 0);
    QCOMPARE(view.minutes(), 0.0);
    QVERIFY(view.anyBreak()); // there may be
    QCOMPARE(view.parts.front().objects, 2);
}

QTEST_GUILESS_MAIN(TestPilotRun)
#include "test_pilot_run.moc"
