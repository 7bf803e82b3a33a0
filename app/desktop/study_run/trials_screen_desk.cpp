// SPDX-License-Identifier: GPL-3.0-or-later
// The participant's page and the experimenter's desk in a study session: who sees which of them, and the
// changes between them.
#include "desktop/studies/study_screen.h"
#include "desktop/study_run/trials_screen.h"

#include "desktop/frame/app_context.h"
#include "desktop/study_run/break_panel.h"
#include "desktop/study_run/condition_questions.h"
#include "desktop/study_run/experimenter_gate.h"
#include "desktop/study_run/experimenter_panel.h"
#include "desktop/study_run/participant_window.h"
#include "desktop/widgets/state_panel.h"
#include "session/study/participant_view.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>

namespace chiron::desktop {

bool TrialsScreen::atDesk() const {
    return m_window || m_faces->currentWidget() == m_desk;
}

/// If there is a second screen, the participant sits in front of it; the desk stays here.
void TrialsScreen::placePage() {
    QScreen* second = place().parameters.value(QStringLiteral("one_screen")).toBool()
                          ? nullptr
                          : ParticipantWindow::otherScreen(*this);
    if (!second)
        return;
    m_window = new ParticipantWindow(context().theme(), *second, this);
    connect(m_window, &ParticipantWindow::lost, this, &TrialsScreen::bringBack, Qt::QueuedConnection);
    m_faces->removeWidget(m_page);
    m_window->take(m_page);
    m_page->show();
    m_call->hide();
    m_toPage->hide();
    m_faces->setCurrentWidget(m_desk);
    m_deskNote->setText(tr("The participant's page is on the other screen."));
}

void TrialsScreen::bringBack() {
    if (!m_window)
        return;
    if (running())
        m_live->pause();
    freePointer();
    m_window->giveBack();
    m_window->deleteLater();
    m_window = nullptr;
    m_faces->insertWidget(0, m_page);
    m_call->show();
    m_toPage->setVisible(running());
    m_deskNote->setText(
        running() ? tr("The participant's screen is no longer connected. The session is paused, and "
                       "everything so far is kept. The participant's page is in this window now.")
                  : m_ended + QLatin1Char('\n') +
                        tr("The participant's screen is no longer connected. The participant's page is in "
                           "this window now."));
}

/// Whether the experimenter must identify themselves before anybody sees the desk or continues.
bool TrialsScreen::guarded() const {
    // A pilot belongs to its author and produces no data.
    return m_live && !isPilot() && (m_live->design().blindParticipant || m_live->design().blindExperimenter);
}

void TrialsScreen::callExperimenter(std::function<void()> then) {
    if (m_gate)
        return;
    if (running()) {
        m_live->pause();
        freePointer();
    }
    if (atDesk() || !guarded()) {
        then();
        return;
    }
    m_gate = true;
    auto* gate = new ExperimenterGate(
        context(),
        running() ? tr("The session is paused. Enter your password to see the experimenter's view.")
                  : tr("The session is over. Enter your password to go on with the study."),
        window());
    connect(gate, &ExperimenterGate::opened, this, [this, then = std::move(then)] {
        m_gate = false;
        then();
    });
    connect(gate, &QDialog::rejected, this, [this] { m_gate = false; });
    gate->open();
}

void TrialsScreen::showDesk() {
    m_faces->setCurrentWidget(m_desk);
    m_toPage->setVisible(running() && !m_window);
    m_deskNote->setText(
        running() ? tr("The session is paused. Before you hand over, go back to the participant's page.")
                  : m_ended);
    if (running())
        m_experimenter->show(m_live->view(), m_live->numbers(), m_live->condition());
    (m_toPage->isHidden() ? m_leave : m_toPage)->setFocus(Qt::OtherFocusReason);
}

void TrialsScreen::showPage() {
    if (m_window)
        return;
    m_faces->setCurrentWidget(m_page);
    m_break->focusButton();
    m_changed.start(); // the experimenter's second press does not go on for the participant
}

/// Handles F2 and "Experimenter …".
void TrialsScreen::toggleExperimenter() {
    if (m_window)
        return; // the desk is always visible
    if (atDesk())
        showPage();
    else if (m_over)
        callExperimenter([this] { leave(); });
    else
        callExperimenter([this] { showDesk(); });
}

void TrialsScreen::askQuestions(const QString& what) {
    m_ended = what;
    m_panel->showContent();
    m_questions =
        new ConditionQuestions(context(), m_live->design(), {m_study, m_participant, m_live->result()->run});
    m_questions->setObjectName(QStringLiteral("trials.questions"));
    connect(m_questions, &ConditionQuestions::answered, this, [this] { showEnd(m_ended); });
    m_stage->addWidget(m_questions);
    m_stage->setCurrentWidget(m_questions);
    clearHead(tr("%1 The participant is now answering the questions about it.").arg(what));
}

/// On a second screen the participant's page has a window of its own. The keys are the participant's, also
/// after the experimenter has pressed something at the desk.
void TrialsScreen::returnKeys() {
    if (m_window && running())
        m_window->activateWindow();
}

void TrialsScreen::clearHead(const QString& note) {
    m_strip->clear();
    m_stop->hide();
    m_progress->hide();
    m_leave->show();
    m_toPage->hide();
    m_deskNote->setText(note);
}

/// Nothing on it tells how the answers were.
void TrialsScreen::sayEnd() {
    const core::Result<session::LiveStudyResult>& result = m_live->result();
    const int left = m_live->view().partsToCome;
    if (isPilot())
        m_break->say(tr("The pilot run is over"), tr("What was tried does not count as data of the study."),
                     tr("Go on"));
    else if (!result)
        m_break->say(tr("The session was stopped"), tr("Please call the experimenter."), {});
    else if (!result->completed)
        m_break->say(tr("The session was stopped"),
                     tr("This part is not finished; your answers so far are kept. Please call the "
                        "experimenter, who decides when it goes on."),
                     {});
    else if (left > 0)
        m_break->say(tr("This part is finished"),
                     tr("Thank you. %n more part(s) follow. Please call the experimenter, who decides when "
                        "the next one begins.",
                        nullptr, left),
                     {});
    else if (session::participantView(m_live->design()).questionsAfter > 0)
        m_break->say(tr("All trials are finished"),
                     tr("Thank you. Only a few questions about the study are left. Please call the "
                        "experimenter, who opens them."),
                     {});
    else
        m_break->say(tr("Everything is finished"),
                     tr("Thank you. Nothing more is left for you to do in this study. Please call the "
                        "experimenter."),
                     {});
}

void TrialsScreen::showEnd(const QString& what) {
    m_ended = what;
    m_panel->showContent();
    sayEnd();
    m_break->countDown(-1.0, 0.0);
    m_stage->setCurrentWidget(m_break);
    clearHead(what);
    // Keys on the participant's page call nobody: only a pilot run goes on from there.
    if (atDesk())
        m_leave->setFocus(Qt::OtherFocusReason);
    else
        m_page->setFocus(Qt::OtherFocusReason);
    if (!atDesk() && isPilot()) // not at once: a key that was meant for the last trial leaves nothing
        QTimer::singleShot(kOnePress_ms, m_break, [this] { m_break->focusButton(); });
}

QVariant TrialsScreen::triedStudy() const {
    return place().parameters.value(QStringLiteral("pilot_of"));
}

void TrialsScreen::leave() {
    m_released = true;
    if (m_completed)
        context().messages().done(m_ended);
    else if (!m_ended.isEmpty())
        context().messages().information(m_ended);
    // A pilot returns to the design that was tried.
    if (const QVariant draft = triedStudy(); draft.isValid()) {
        context().navigator().replace(
            {QStringLiteral("study"),
             {{QStringLiteral("study"), draft}, {QStringLiteral("tab"), int(StudyScreen::checkTab)}}});
        return;
    }
    context().navigator().replace({QStringLiteral("study_run"),
                                   {{QStringLiteral("study"), qlonglong(m_study)},
                                    {QStringLiteral("participant"), m_participant},
                                    {QStringLiteral("just_ran"), true}}});
}

bool TrialsScreen::mayLeave() {
    if (m_released || !m_live || m_panel->state() != StatePanel::State::content)
        return true; // it never started, so the experimenter is still there
    if (!atDesk() && guarded()) {
        callExperimenter([this] { m_over ? leave() : showDesk(); });
        return false;
    }
    if (running())
        askToStop();
    return !running() || m_live->finished();
}

} // namespace chiron::desktop
