// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of what the screens of studies show only after somebody did something: sittings, dialogs, a
// preview; and of studies of other kinds.
#pragma once

#include "support/patience.h"
#include "support/sitting_hands.h"

#include <QDialog>
#include <cstdio>
#include <functional>

namespace chiron::tests {

/// Studies beside the visited ones, rhea's as well.
struct MoreStudies {
    database::StudyNumber ties = 0; ///< rankings in which objects may be called equal
    database::StudyNumber apex = 0;
    QString apexCode; ///< has consented to it
};

inline psychophysics::StudyDesign tiedStudy() {
    psychophysics::StudyDesign design = smallStudy("ranks_with_ties");
    design.title = {{"en", "Rankings with ties"},
                    {"de", "Rangfolgen mit Gleichständen"},
                    {"el", "Κατατάξεις με ισοπαλίες"}};
    design.conditions.resize(1);
    design.conditions.front().task = psychophysics::Task::rank3Ties;
    std::get<psychophysics::Rank3Spec>(design.conditions.front().procedures.front()).allowTies = true;
    return design;
}

inline psychophysics::StudyDesign hiddenApexStudy() {
    psychophysics::StudyDesign design = apexStudy("apex_trials", 4);
    design.trial.visibleObjects = false;
    return design;
}

inline MoreStudies addMoreStudies(DesktopFixture& desktop) {
    const database::Actor rhea = desktop.actor("rhea");
    if (!database::AccountService(desktop.database())
             .createPerson(desktop.actor("ada"),
                           {"rob", "Rob Runner", {database::Role::researcher}, kTestPassword, false}))
        qFatal("no second researcher");
    MoreStudies more;
    const auto frozen = [&](const psychophysics::StudyDesign& design) {
        const auto study = addDraft(desktop, rhea, design);
        writeAs(desktop, rhea, [&](database::StudyRepository& all) { return all.freezeStudy(study); });
        return study;
    };
    const psychophysics::StudyDesign tied = tiedStudy();
    more.ties = frozen(tied);
    for (int i = 0; i < 3; ++i)
        addRun(desktop, rhea, tied,
               addParticipant(desktop, rhea, more.ties, tied, "resident " + std::to_string(i)), "stiffness",
               0.08 + 0.03 * i, static_cast<std::uint64_t>(41 + i));
    const psychophysics::StudyDesign apex = hiddenApexStudy();
    more.apex = frozen(apex);
    more.apexCode = QString::fromStdString(addParticipant(desktop, rhea, more.apex, apex, "surgeon 5").code);
    return more;
}

inline void addMorePlaces(std::vector<VisitedPlace>& places, const VisitedStudies& studies,
                          const MoreStudies& more) {
    const auto add = [&](const char* name, const char* person, const char* screen,
                         database::StudyNumber study, int tab) {
        places.push_back(
            {name, person, {QLatin1String(screen), QVariantMap{{"study", qlonglong(study)}, {"tab", tab}}}});
    };
    add("data_ties", "rhea", "study_data", more.ties, 0);
    add("data_ties_person", "rhea", "study_data", more.ties, 1);
    add("data_apex", "rhea", "study_data", more.apex, 0);
    add("study_ties", "rhea", "study", more.ties, 1);
    add("study_masked_conditions", "rob", "study", studies.blind, 1);
    add("study_masked_trials", "rob", "study", studies.blind, 2);
    add("study_masked_preview", "rob", "study", studies.blind, 4);
    add("run_masked", "rob", "study_run", studies.blind, 0);
    add("data_masked", "rob", "study_data", studies.blind, 1);
}

struct StudyPictures {
    DesktopFixture& desktop;
    const VisitedStudies& studies;
    const MoreStudies& more;
    std::string& person;
    std::function<void(const char*)> picture;
    std::function<void(const char*, QWidget&)> dialog;

    /// A participant's view and the experimenter's beside it; then what is left of it.
    void trials() {
        sit({"run_trials",
             "rhea",
             {QStringLiteral("study_trials"),
              {{"study", qlonglong(studies.data)}, {"participant", studies.waiting}}}});
        picture("run_trials_instructions");
        press("break.button");
        QTest::qWait(500);
        picture("run_trials_card");
        press("training.ready.go");
        QTest::qWait(4000);
        picture("run_trials_free_minute");
        press("trials.enough");
        QTest::qWait(4000);
        picture("run_trials_participant");
        press("trials.experimenter");
        QTest::qWait(500);
        if (auto* gate = desktop.find<QDialog>(QStringLiteral("gate")))
            dialog("run_trials_gate", *gate);
        (void)typePassword(desktop);
        QTest::keyClick(desktop.window.get(), Qt::Key_1);
        QTest::keyClick(desktop.window.get(), Qt::Key_3);
        QTest::qWait(500);
        picture("run_trials_experimenter");
        press("experimenter.pause");
        QTest::qWait(700);
        picture("run_trials_paused");
        stop();
        waitUntilLoaded(desktop);
        picture("run_interrupted");
    }

    void apexTrials() {
        sit({"run_apex",
             "rhea",
             {QStringLiteral("study_trials"),
              {{"study", qlonglong(more.apex)}, {"participant", more.apexCode}}}});
        press("break.button");
        press("training.ready.go");
        QTest::qWait(4000);
        press("trials.enough");
        QTest::qWait(5000);
        picture("run_apex");
        press("trials.experimenter");
        (void)typePassword(desktop);
        QTest::qWait(500);
        picture("run_apex_experimenter");
        QTest::keyClick(desktop.window.get(), Qt::Key_Escape);
        QTest::qWait(700);
        picture("run_apex_stopped");
        stop();
    }

    /// Each is opened by its button, as it is with nothing filled in.
    void dialogs() {
        visit(desktop, {"studies", "rhea", {QStringLiteral("studies"), {}}}, person);
        opened("studies.new", "study_dialog_new");
        visit(desktop, {"draft", "rhea", {QStringLiteral("study"), {{"study", qlonglong(studies.draft)}}}},
              person);
        opened("study.freeze", "study_dialog_freeze");
        const VisitedPlace participants{
            "participants", "rhea", {QStringLiteral("study"), {{"study", qlonglong(more.apex)}, {"tab", 5}}}};
        for (const auto& [button, name] : {std::pair{"participants.withdraw", "study_dialog_withdraw"},
                                           {"participants.keys", "study_dialog_keys"},
                                           {"participants.enrol", "study_dialog_enrol"}}) {
            visit(desktop, participants, person);
            opened(button, name);
        }
    }

    void preview() {
        visit(
            desktop,
            {"preview", "rhea", {QStringLiteral("study"), {{"study", qlonglong(studies.draft)}, {"tab", 4}}}},
            person);
        press("preview.start");
        if (!QTest::qWaitFor(
                [this] { return desktop.find<QWidget>(QStringLiteral("preview.result")) != nullptr; },
                kPatience_ms))
            std::fprintf(stderr, "the preview did not come\n");
        picture("study_preview_done");
    }

private:
    void press(const char* name) {
        if (auto* button = desktop.find<QPushButton>(QLatin1String(name)))
            button->click();
        else
            std::fprintf(stderr, "no button %s\n", name);
    }
    void sit(const VisitedPlace& place) { visit(desktop, place, person); }
    void opened(const char* button, const char* name) {
        press(button);
        QTest::qWait(300);
        if (QWidget* shown = QApplication::activeModalWidget()) {
            dialog(name, *shown);
            shown->close();
        } else {
            std::fprintf(stderr, "no dialog of %s\n", button);
        }
        QTest::qWait(100);
    }
    void stop() {
        QTimer look; // the question comes when it comes
        QObject::connect(&look, &QTimer::timeout, qApp, [this] {
            if (auto* button = desktop.find<QPushButton>(QStringLiteral("trials.ask.stop")))
                button->click();
        });
        look.start(200);
        press("trials.stop");
        if (!QTest::qWaitFor([this] { return !desktop.context.trialRuns(); }, kPatience_ms))
            std::fprintf(stderr, "the sitting did not end\n");
        if (auto* leave = desktop.find<QPushButton>(QStringLiteral("trials.leave"));
            leave && !leave->isHidden())
            leave->click();
    }
};

} // namespace chiron::tests
