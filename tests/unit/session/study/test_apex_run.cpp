// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/study_catalogue.h"
#include "catalogue/study_json.h"
#include "curriculum/exercises/sphere_apex/catalogue/apex_study_content.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"
#include "session/study/apex_analysis.h"
#include "session/study/study_runner.h"
#include "session/study/study_store.h"
#include "support/looked_back.h"
#include "support/session_fixture.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace chiron;

namespace {

/// The content's study, with so many scored trials and one for practice.
psychophysics::StudyDesign apexDesign(int scored) {
    const auto content = catalogue::StudyCatalogue::load();
    if (!content)
        qFatal("%s", content.error().message.c_str());
    psychophysics::StudyDesign design = *content->find("apex");
    std::get<psychophysics::ConstantSpec>(design.conditions.front().procedures.front()).repeats = scored;
    return design;
}

/// A frozen study in a database of its own, done by simulated participants.
struct Site {
    template <class Job> auto write(Job job) {
        auto done = fixture.database->write([&](database::WriteContext& context) {
            database::StudyRepository studies(context.connection(), actor);
            return job(studies);
        });
        if (!done)
            qFatal("%s", done.error().message.c_str());
        return done;
    }
    explicit Site(psychophysics::StudyDesign of) : design(std::move(of)) {
        study = *write([&](database::StudyRepository& studies) {
            return studies.createStudy(design.id, "Apex", catalogue::studyJson(design).toStdString());
        });
        write([&](database::StudyRepository& studies) { return studies.freezeStudy(study); });
    }
    std::string enrol() {
        return write([&](database::StudyRepository& studies) {
                   return studies.enrolParticipant(study, {}, 0, "weber:0.1");
               })
            ->code;
    }
    auto run(const std::string& code, bool quick = false, int trialsAtMost = 0) {
        session::StudyRunRequest request;
        request.study = study;
        request.participantCode = code;
        request.quick = quick;
        request.trialsAtMost = trialsAtMost;
        return session::runStudyHeadless(*fixture.database, actor, request);
    }
    std::vector<database::StudyTrial> trials(const std::string& code) {
        const auto opened = session::openStudy(*fixture.database, actor, study, code);
        auto connection = fixture.database->openReader();
        return *database::StudyReader(**connection, actor).studyTrials(opened->runs.front().id);
    }

    tests::SessionFixture fixture;
    database::Actor actor = database::Actor::simulated();
    psychophysics::StudyDesign design;
    database::StudyNumber study = 0;
};

bool warns(const std::vector<psychophysics::Warning>& warnings, const std::string& token) {
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const psychophysics::Warning& each) { return warningToken(each.kind) == token; });
}

} // namespace

class TestApexRun : public QObject {
    Q_OBJECT
private slots:
    /// What is stored is where the hand was at the tick of the mark, less where the sphere of that trial lies
    /// by the session's seed.
    void theErrorIsThatOfTheRecordedMark() {
        Site site(apexDesign(3));
        const std::string code = site.enrol();
        const auto report = site.run(code);
        QVERIFY2(report, report ? "" : report.error().message.c_str());
        QVERIFY(report->completed);
        const auto trials = site.trials(code);
        QVERIFY(trials.size() >= 4);
        std::set<double> places;
        for (const database::StudyTrial& trial : trials) {
            const tests::OpenStored stored(*site.fixture.database, trial.session);
            const auto& p = stored.session->setup().level.parameters.as<simulation::SphereApexParameters>();
            QVERIFY(p.cues.empty());
            QCOMPARE(p.radius_m, 0.02);
            QCOMPARE(p.stiffnessLow_N_per_m, 500.0);
            const auto trace = tests::traceOf(*stored.session);
            QVERIFY(trace);
            const auto mark = session::apexMarkOf(trial.fidelityJson);
            const auto at =
                std::find_if(trace->trials.begin(), trace->trials.end(), [&](const scoring::TrialTrace& t) {
                    // traces are on a grid of nanometres
                    return mark && t.target &&
                           std::abs(t.p_WMark_m.x() - t.target->x_m - mark->errorX_m) < 1e-9 &&
                           std::abs(t.p_WMark_m.y() - t.target->y_m - mark->errorY_m) < 1e-9;
                });
            QVERIFY2(at != trace->trials.end(), "no recorded mark has this error");
            QCOMPARE(mark->inContact, at->markInContact);
            places.insert(at->target->x_m);
            QCOMPARE(*trial.value, std::hypot(mark->errorX_m, mark->errorY_m));
        }
        QCOMPARE(places.size(), trials.size()); // each sphere lies elsewhere
    }
    void anInterruptedRunGoesOnAtTheTrial() {
        Site site(apexDesign(3));
        const std::string code = site.enrol();
        QVERIFY(!site.run(code, false, 2)->completed);
        const auto before = site.trials(code);
        QCOMPARE(before.size(), std::size_t(2));
        QVERIFY(!site.run(code, true)); // begun through the rendering: it goes on like that
        QVERIFY(site.run(code)->completed);
        const auto after = site.trials(code);
        for (std::size_t i = 0; i < before.size(); ++i)
            QCOMPARE(after[i].fidelityJson, before[i].fidelityJson);
        QVERIFY(after[2].session != before[1].session);
        QCOMPARE(std::count_if(after.begin(), after.end(),
                               [](const auto& t) { return !t.practice && t.spoiled.empty(); }),
                 3);
        const auto opened = session::openStudy(*site.fixture.database, site.actor, site.study, code);
        const auto again = session::rerunChoices(site.design, opened->runs.front(), after);
        QCOMPARE(again->same, again->trials);
    }
    /// A limit that every trial passes: each comes again, unscored, until nobody is there to say that it may
    /// go on.
    void spoiledTrialsComeAgain() {
        psychophysics::StudyDesign design = apexDesign(2);
        design.trial.practiceTrials = 0;
        design.fidelity.meanSpeed_m_per_s = 0.001;
        design.fidelity.repeatsAtMost = 3;
        Site site(design);
        const std::string code = site.enrol();
        const auto report = site.run(code);
        QVERIFY2(report, report ? "" : report.error().message.c_str());
        QVERIFY(!report->completed);
        QCOMPARE(report->runs.front().scored, 0);
        const auto trials = site.trials(code);
        QCOMPARE(trials.size(), std::size_t(3));
        for (const database::StudyTrial& trial : trials)
            QCOMPARE(trial.spoiled, std::string("speed"));
    }
    /// The analysis of a study, from what is stored: equal to that of the rows themselves.
    void theAnalysisIsThatOfTheStoredRows() {
        Site site(apexDesign(6));
        std::vector<psychophysics::ApexTrial> all;
        for (int person = 0; person < 3; ++person) {
            const std::string code = site.enrol();
            QVERIFY(site.run(code, true)->completed);
            const auto own = session::apexTrials(site.trials(code), person);
            QCOMPARE(own.size(), std::size_t(6)); // practice is not among them
            all.insert(all.end(), own.begin(), own.end());
        }
        auto connection = site.fixture.database->openReader();
        database::StudyReader reader(**connection, site.actor);
        const auto analysis = session::analyseStudy(reader, site.study, 5);
        QVERIFY(analysis);
        const auto& condition = analysis->conditions.front();
        const auto direct = psychophysics::summariseApex(all, 0.02, 1); // the seed is of the bootstrap alone
        QVERIFY(condition.apex);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            QCOMPARE(condition.apex->axes[axis].bias_mm, direct.axes[axis].bias_mm);
            QCOMPARE(condition.apex->axes[axis].sd_mm, direct.axes[axis].sd_mm);
            QCOMPARE(condition.apex->axes[axis].sdBetween_mm, direct.axes[axis].sdBetween_mm);
        }
        QCOMPARE(condition.apex->meanAbsolutePercent, direct.meanAbsolutePercent);
        QCOMPARE(condition.apex->participants, 3);
        QCOMPARE(condition.group.participants, 3);
        QVERIFY(warns(condition.apex->warnings, "planned"));
        QVERIFY(warns(condition.apex->warnings, "simulated"));
        QVERIFY(!warns(condition.runs.front().apex->warnings, "few_participants"));
        QVERIFY(std::isnan(condition.runs.front().estimate.weber)); // nothing was compared
        QCOMPARE(condition.runs.front().estimate.trials, 6);
    }
    void whatCannotBeMadeIsRefused() {
        psychophysics::Condition condition = apexDesign(2).conditions.front();
        QVERIFY(catalogue::apexOf(condition, {}, 4));
        condition.stimulus.fixed["mass_kg"] = 0.1;
        QVERIFY(catalogue::apexOf(condition, {}, 4).error().message.find("mass_kg") != std::string::npos);
        condition.stimulus.fixed.clear();
        condition.stimulus.reference = 0.08;
        QCOMPARE(catalogue::apexOf(condition, {}, 4).error().code, core::ErrorCode::badInput);
        condition.stimulus.attribute = psychophysics::Attribute::mass;
        QCOMPARE(catalogue::apexOf(condition, {}, 4).error().code, core::ErrorCode::badInput);
    }
    void aMarkIsReadBack() {
        session::TrialFidelity fidelity;
        QVERIFY(!session::apexMarkOf(session::fidelityJson(fidelity)));
        fidelity.apex = session::ApexMark{0.0012345678901234, -0.004, 0.02, true, false};
        const auto back = session::apexMarkOf(session::fidelityJson(fidelity));
        QVERIFY(back);
        QCOMPARE(back->errorX_m, 0.0012345678901234);
        QCOMPARE(back->errorY_m, -0.004);
        QVERIFY(back->inContact && !back->planned);
        QVERIFY(!session::apexMarkOf("not json"));
    }
};

QTEST_GUILESS_MAIN(TestApexRun)
#include "test_apex_run.moc"
