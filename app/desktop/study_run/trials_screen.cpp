// SPDX-License-Identifier: GPL-3.0-or-later
// A sitting from its instructions to its end. What is shown meanwhile: trials_screen_show.cpp.
#include "desktop/study_run/trials_screen.h"

#include "desktop/frame/app_context.h"
#include "desktop/station/device_delay.h"
#include "desktop/studies/study_screen.h"
#include "desktop/studies/study_words.h"
#include "desktop/study_run/answer_panel.h"
#include "desktop/study_run/break_panel.h"
#include "desktop/study_run/experimenter_panel.h"
#include "desktop/study_run/places_view.h"
#include "desktop/training/key_filter.h"
#include "desktop/widgets/state_panel.h"
#include "recording/crash_ring.h"

#include <QApplication>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>

namespace chiron::desktop {

using State = session::LiveStudyView::State;

namespace {
constexpr int kFrame_ms = 16;
}

TrialsScreen::~TrialsScreen() {
    m_keys->setActive(false);
    m_pointer.reset();
    m_hand.reset();
    m_live.reset(); // ends the sitting; the run stays open
    context().setTrialRuns(false);
}

QString TrialsScreen::title() const { return tr("Study"); }

QString TrialsScreen::help() const {
    return tr("Here a participant explores objects and answers.\n\nMove the tool with the mouse; raise and lower it with the wheel or "
              "PageUp and PageDown. T frees the pointer, and a click in the scene captures it again. Answer with the buttons or with the "
              "keys shown on them.\n\nSpace pauses. Esc stops force at once and R brings it back slowly; pressing Esc again asks whether "
              "to stop the sitting. F2 shows the experimenter's view: progress, estimate, fidelity of the last trial, and the button that "
              "discards a trial. All answered trials are kept; a stopped run continues later at the same trial.");
}

void TrialsScreen::enter() {
    m_note->setText(tr("Participant %1").arg(m_participant));
    m_panel->showLoading(tr("Reading the study …"));
    begin();
}

void TrialsScreen::begin() {
    session::LiveStudyRequest request;
    request.study = m_study;
    request.participantCode = m_participant.toStdString();
    request.condition = m_condition;
    request.ringFolder = recording::defaultRingFolder();
    auto station = session::keyboardMouseStation();
    if (!station) {
        fail(station.error());
        return;
    }
    request.measuredDelay_s = measuredDelay_s(context().settings(), station->devices.front()->descriptor());
    request.station = std::move(*station);
    request.nextStation = [] { return session::keyboardMouseStation(); };
    auto live = session::LiveSitting::start(context().site().database(), context().actor(), std::move(request));
    if (!live) {
        const QString words = refusalWords(live.error(), context().locale());
        words.isEmpty() ? fail(live.error()) : refuse(words);
        return;
    }
    m_live = std::move(*live);
    context().setTrialRuns(true);
    buildLive();
    connectPointer();
    if (m_live->design().trial.maskingSound)
        m_sound.open();
    m_live->pause(); // nothing is presented until the instructions are read
    m_break->say(tr("Before you begin"), study_words::text(m_live->design().instructions, context().language()), tr("Begin"));
    m_stage->setCurrentWidget(m_break);
    m_panel->showContent();
    m_break->focusButton();
    m_frame.start(kFrame_ms);
}

void TrialsScreen::poll() {
    if (!running())
        return;
    m_live->poll();
    if (m_live->sessions() != m_sessions) {
        connectPointer(); // the session before took its pointer along
        if (m_begun && m_stage->currentWidget() == m_trial)
            capturePointer();
    }
    const session::LiveStudyView view = m_live->view();
    if (m_begun)
        showState(view);
    if (m_experimenter->isVisible())
        m_experimenter->show(view, m_live->numbers(), m_live->condition());
    if (m_live->finished())
        finished();
}

void TrialsScreen::onBreakButton() {
    if (!running())
        return;
    m_begun = true;
    switch (m_live->view().state) {
    case State::breakDue:
        if (m_live->view().breakLeft_s <= 0.0)
            m_live->breakTaken();
        break;
    case State::needsExperimenter:
        m_live->experimenterSays(true);
        break;
    case State::stopped:
        m_live->rearm();
        break;
    default:
        m_live->resume();
        break;
    }
}

void TrialsScreen::answer(int answer, std::optional<double> value) {
    if (!running())
        return;
    if (const auto taken = m_live->answer(answer, value); !taken)
        context().messages().error(tr("The answer was not accepted."), taken.error());
    m_answers->clear();
}

void TrialsScreen::mark() {
    if (running() && m_apex && m_live->view().canAnswer)
        (void)m_live->answer(0); // where none is taken any more, the trial has just ended
}

void TrialsScreen::pauseOrResume() {
    if (!running() || m_live->view().state == State::stopped)
        return; // that takes R
    if (m_live->view().state == State::paused)
        onBreakButton();
    else
        m_live->pause();
}

/// While the instructions are read nothing is rendered; and who has stopped force already wants more.
void TrialsScreen::stopForce() {
    if (!running())
        return;
    if (!m_begun || m_live->view().state == State::stopped)
        askToStop();
    else
        m_live->stopForce();
}

void TrialsScreen::rearm() {
    if (running() && m_begun)
        m_live->rearm();
}

void TrialsScreen::freePointer() {
    if (m_hand)
        m_hand->releaseKeys();
    if (m_pointer)
        m_pointer->release();
}

void TrialsScreen::capturePointer() {
    if (m_pointer && running() && QApplication::applicationState() == Qt::ApplicationActive)
        m_pointer->capture();
}

void TrialsScreen::toggleExperimenter() {
    m_experimenter->setVisible(!m_experimenter->isVisible());
    if (running() && m_experimenter->isVisible())
        m_experimenter->show(m_live->view(), m_live->numbers(), m_live->condition());
}

void TrialsScreen::askToStop() {
    if (!running() || m_asking)
        return;
    m_asking = true;
    m_live->pause();
    freePointer();
    QMessageBox box(QMessageBox::Question, title(), tr("Stop this sitting?"), QMessageBox::NoButton, window());
    box.setObjectName(QStringLiteral("trials.ask"));
    box.setInformativeText(tr("All answered trials are kept. The run continues later at the same trial."));
    QPushButton* keep = box.addButton(tr("Keep going"), QMessageBox::RejectRole);
    keep->setObjectName(QStringLiteral("trials.ask.keep"));
    QPushButton* stop = box.addButton(tr("Stop"), QMessageBox::DestructiveRole);
    stop->setObjectName(QStringLiteral("trials.ask.stop"));
    box.setDefaultButton(keep);
    box.setEscapeButton(keep);
    box.exec();
    m_asking = false;
    if (running() && box.clickedButton() == stop)
        m_live->stop();
}

bool TrialsScreen::mayLeave() {
    askToStop();
    return !running() || m_live->finished();
}

void TrialsScreen::finished() {
    m_over = true;
    m_frame.stop();
    m_sound.silence();
    m_keys->setActive(false);
    freePointer();
    context().setTrialRuns(false);
    const core::Result<session::LiveStudyResult>& result = m_live->result();
    if (!result) {
        fail(result.error());
        return;
    }
    if (result->completed)
        context().messages().done(tr("This condition is completed."));
    else
        context().messages().information(tr("All answered trials are kept. The run continues at the same trial."));
    goBack();
}

void TrialsScreen::goBack() {
    if (const QVariant draft = place().parameters.value(QStringLiteral("pilot_of")); draft.isValid()) { // a pilot goes back to the design that was tried
        context().navigator().replace({QStringLiteral("study"), {{QStringLiteral("study"), draft}, {QStringLiteral("tab"), int(StudyScreen::checkTab)}}});
        return;
    }
    context().navigator().replace({QStringLiteral("study_run"), {{QStringLiteral("study"), qlonglong(m_study)}, {QStringLiteral("participant"), m_participant}}});
}

void TrialsScreen::fail(const core::Error& error) {
    over();
    m_panel->showError(tr("The sitting could not be run"), error, [this] { goBack(); });
}

/// No failure: another device, or another study, is what it takes.
void TrialsScreen::refuse(const QString& words) {
    over();
    m_panel->showEmpty(tr("Not possible with this device"), words, tr("Back to the participant"), [this] { goBack(); });
}

void TrialsScreen::over() {
    m_over = true;
    m_frame.stop();
    m_keys->setActive(false);
    context().setTrialRuns(false);
}

QString TrialsScreen::refusalWords(const session::SittingError& error, const QLocale& locale) {
    if (error.device == session::DeviceRefusal::rendersNone)
        return tr("Because of its delay, this device can render none of the differences in this condition. Use a faster or stronger "
                  "device, or plan another reference in another study.");
    if (error.device == session::DeviceRefusal::rendersLess)
        return tr("This run was started on a device that renders larger differences than this one. It can be continued only with such a "
                  "device, so that all of its trials can be compared.");
    if (error.otherVersion)
        return tr("This run was started with a different version of its procedure. A run is never continued with another version, so that "
                  "all of its trials can be compared. The answers so far are kept; enrol another participant for this condition.");
    if (!error.tooStiff)
        return {};
    return tr("The sphere is too stiff for this device: the study asks for %1 N/m, but with its delay the device can render at most %2 N/m "
              "stably. Use a faster device, or plan a softer sphere in another study.")
        .arg(locale.toString(qRound(error.tooStiff->sphere_N_per_m)), locale.toString(qRound(error.tooStiff->device_N_per_m)));
}

std::vector<ScreenCommand> TrialsScreen::commands() {
    return {{tr("Experimenter's view"), QKeySequence(Qt::Key_F2), [this] { toggleExperimenter(); }, !running()},
            {tr("Pause or go on"), QKeySequence(Qt::Key_Space), [this] { pauseOrResume(); }, false},
            {tr("Stop force"), QKeySequence(Qt::Key_Escape), [this] { stopForce(); }, false},
            {tr("Re-arm force"), QKeySequence(Qt::Key_R), [this] { rearm(); }, false},
            {tr("Stop the sitting"), {}, [this] { askToStop(); }, true}};
}

} // namespace chiron::desktop
