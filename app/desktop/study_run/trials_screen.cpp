// SPDX-License-Identifier: GPL-3.0-or-later
// A study session from its instructions to its end. trials_screen_show.cpp updates the display meanwhile.
#include "desktop/study_run/trials_screen.h"

#include "desktop/frame/app_context.h"
#include "desktop/frame/help_dialogs.h"
#include "desktop/station/device_delay.h"
#include "desktop/studies/participant_sentences.h"
#include "desktop/studies/study_device.h"
#include "desktop/studies/study_words.h"
#include "desktop/study_run/answer_panel.h"
#include "desktop/study_run/break_panel.h"
#include "desktop/study_run/condition_questions.h"
#include "desktop/study_run/experimenter_panel.h"
#include "desktop/study_run/participant_window.h"
#include "desktop/study_run/places_view.h"
#include "desktop/study_run/sitting_sentences.h"
#include "desktop/study_run/study_controls.h"
#include "desktop/training/felt_words.h"
#include "desktop/training/key_filter.h"
#include "desktop/training/ready_card.h"
#include "desktop/widgets/state_panel.h"
#include "recording/crash_ring.h"
#include "session/study/participant_view.h"

#include <QApplication>
#include <QLabel>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QStackedWidget>
#include <algorithm>

namespace chiron::desktop {

using State = session::LiveStudyView::State;

namespace {
constexpr int kFrame_ms = 16;
constexpr double kFreeMinute_s = 60.0; // long enough to try every control, short enough not to tire

QString paragraphs(QStringList texts) {
    texts.removeAll(QString());
    return texts.join(QStringLiteral("\n\n"));
}

} // namespace

TrialsScreen::~TrialsScreen() {
    m_keys->setActive(false);
    m_pointer.reset();
    m_hand.reset();
    m_live.reset(); // ends the session; the run stays open
    context().setTrialRuns(false);
}

QString TrialsScreen::title() const {
    return tr("Study");
}

/// Before the session starts, the station's device tells.
bool TrialsScreen::rendersForce() const {
    return m_live ? m_live->training().felt() : studyDeviceRendersForce();
}

/// Participants read this as well, so it reveals no more than their own page.
QString TrialsScreen::help() const {
    const QString keys = felt_words::stopKeys(rendersForce());
    return paragraphs(
        {tr("Here a participant explores objects and answers."),
         tr("Move the tool with the device, or with the mouse; with the mouse, raise and lower it with the "
            "wheel or Page Up and Page Down. T frees the pointer, and a click in the scene captures it again "
            "and does not count as an answer. Answer with the buttons or with the keys shown on them, as "
            "soon as they "
            "are enabled."),
         tr("In practice, Backspace takes an answer back."), keys + QLatin1Char(' ') + afterStopText(),
         tr("F2 is for the experimenter.")});
}

/// What becomes of a run that is stopped: the same words in the help, in the question and afterwards.
QString TrialsScreen::afterStopText() const {
    return isPilot()
               ? tr("What was tried in a pilot run does not count as data of the study, and a stopped "
                    "pilot run is not continued.")
               : tr("All answers given so far are kept. The run is not finished: it can be resumed later at "
                    "the same trial, also on another day. If it is not resumed, the answers count in "
                    "the results as far as they suffice for a value.");
}

void TrialsScreen::enter() {
    m_note->setText(tr("Participant %1").arg(participantCode()));
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
    request.measuredDelay_s =
        measuredDelay_s(context().settings(), station->tools.front().device->descriptor());
    request.station = std::move(*station);
    request.freeMinute_s =
        place().parameters.value(QStringLiteral("free_minute_s"), kFreeMinute_s).toDouble();
    request.waitsAfterPractice = true;
    request.language = context().language().toStdString();
    request.nextStation = [] { return session::keyboardMouseStation(); };
    auto live =
        session::LiveSitting::start(context().site().database(), context().actor(), std::move(request));
    if (!live) {
        const QString words = refusalWords(live.error(), context().locale());
        words.isEmpty() ? fail(live.error()) : refuse(words);
        return;
    }
    m_live = std::move(*live);
    context().setTrialRuns(true);
    placePage(); // before the scene is created, which would otherwise have to move
    buildLive();
    connectPointer();
    if (m_live->design().trial.maskingSound)
        (void)m_sound.open(); // polled continuously, because an output may disappear
    showSilence();
    m_live->pause(); // nothing is presented until the instructions are read
    showInstructions();
    m_frame.start(kFrame_ms);
}

/// A participant who has completed a part of the study has read the whole text before. They get a short page,
/// with the whole text one key press away.
void TrialsScreen::showInstructions() {
    if (m_live->view().firstPart)
        return showWholeInstructions();
    m_break->say(tr("The next part"),
                 paragraphs({partText(), furtherPartText(),
                             limitSentence(m_live->design(), m_live->condition(), context().language())}),
                 tr("Continue (Enter)"));
    m_break->offer(tr("Read the whole instruction again"));
    showPageToRead();
}

/// The researcher's own text about this condition; empty if there is none.
QString TrialsScreen::partText() const {
    return study_words::text(m_live->condition().instructions, context().language());
}

/// Describes, from the design, what stays the same and what may differ. The design does not know other
/// changes that a researcher makes (a glove, another hand), so the text must not exclude them.
QString TrialsScreen::furtherPartText() const {
    const session::ParticipantView study = session::participantView(m_live->design());
    const auto anyOther = [&](const auto& same) {
        return std::any_of(study.parts.begin(), study.parts.end(),
                           [&](const session::PartView& part) { return !same(part, study.parts.front()); });
    };
    const bool differs = anyOther([](const session::PartView& a, const session::PartView& b) {
        return a.task == b.task && a.attribute == b.attribute;
    });
    const bool otherNumber = anyOther([](const session::PartView& a, const session::PartView& b) {
        return a.trialsAtMost == b.trialsAtMost && a.trialsFixed == b.trialsFixed;
    });
    QStringList said;
    const bool own = !partText().isEmpty();
    said << (differs ? tr("What you do may differ from the previous part: the next page shows the question "
                          "and how you answer it.")
             : own   ? tr("Apart from this, you explore and answer as in the previous part.")
                     : tr("You explore and answer as in the previous part, unless the experimenter tells you "
                            "otherwise."));
    if (otherNumber)
        said << tr("The number of trials may differ.");
    const auto part =
        std::find_if(study.parts.begin(), study.parts.end(),
                     [&](const session::PartView& each) { return each.condition == m_live->condition().id; });
    if (part != study.parts.end() && part->practice > 0 && m_live->view().tryLeft_s > 0.0)
        said << tr("First come %n practice trial(s), which do not count.", nullptr, part->practice);
    return said.join(QLatin1Char(' '));
}

void TrialsScreen::sayWholeInstructions() {
    m_whole = true;
    m_break->say(
        tr("Before you begin"),
        paragraphs({study_words::text(shownInstructions(m_live->design()), context().language()),
                    sittingSentences(m_live->design(), m_live->condition(), noisePlays(), context().locale()),
                    partText()}),
        tr("Continue (Enter)"));
}

void TrialsScreen::showWholeInstructions() {
    sayWholeInstructions();
    showPageToRead();
}

void TrialsScreen::showPageToRead() {
    m_stage->setCurrentWidget(m_break);
    m_panel->showContent();
    m_break->focusButton();
    m_changed.start();
}

/// Shows the controls of the present device for the coming task.
void TrialsScreen::showCard() {
    const psychophysics::Condition& condition = m_live->condition();
    const StudyHand hand = this->hand();
    ReadyFacts facts;
    facts.exercise = tr("Participant %1").arg(m_participant);
    facts.level = tr("This is how you explore and answer");
    facts.goal = m_apex ? tr("Where is the highest point?")
                        : study_words::question(condition.task, condition.stimulus.attribute);
    facts.controls =
        studyControls(condition.task, condition.stimulus.attribute, hand, letGo(), context().locale());
    facts.keys = studyKeys(condition.task, condition.stimulus.attribute, hand);
    facts.limit = felt_words::objects(hand.felt);
    facts.clock = m_live->view().tryLeft_s > 0.0 ? tr("First comes a free minute to try the controls. "
                                                      "Nothing counts in it, and you can end it at any time.")
                                                 : tr("The trials go on where they were interrupted.");
    facts.offersPractice = false; // the free minute follows anyway
    m_card = new ReadyCard(context().theme(), facts, ReadyCard::Kind::whole);
    m_card->setToolKeys(studyMovementKeys(hand));
    connect(m_card, &ReadyCard::goAsked, this, &TrialsScreen::go);
    connect(m_card, &ReadyCard::helpAsked, this,
            [this] { showHelp(context().theme(), *this, m_page->window()); });
    m_stage->addWidget(m_card);
    m_stage->setCurrentWidget(m_card);
    m_card->takeFocus();
    m_changed.start(); // from now on the card can be seen
}

void TrialsScreen::go() {
    if (!running() || m_begun)
        return;
    m_begun = true;
    m_changed.start();
    m_break->say(tr("One moment …"), {}, {});
    m_stage->setCurrentWidget(m_break); // until the scene is ready, which then takes focus and pointer
    m_card->hide();
    m_card->deleteLater(); // deferred, because the card itself requested this
    m_card = nullptr;
    m_live->resume();
}

void TrialsScreen::stripAction() {
    if (!running())
        return;
    if (m_live->view().state == State::trying)
        m_live->endTrying();
    else
        m_live->goOn();
}

void TrialsScreen::poll() {
    if (!running())
        return;
    m_live->poll();
    if (m_live->sessions() != m_sessions) {
        connectPointer(); // the pointer of the previous session was destroyed with it
        if (m_begun && m_stage->currentWidget() == m_trial)
            capturePointer();
    }
    const session::LiveStudyView view = m_live->view();
    if (m_begun)
        showState(view);
    showSilence();
    if (atDesk())
        m_experimenter->show(view, m_live->numbers(), m_live->condition());
    if (m_live->finished() && !m_asking) // the question stands on this screen, which finished() may leave
        finished();
}

void TrialsScreen::onBreakButton() {
    if (m_over && isPilot())
        return leave();
    if (!running())
        return;
    m_changed.start();
    if (!m_begun) {
        if (!m_card)
            showCard();
        return;
    }
    switch (m_live->view().state) {
    case State::tried:
        m_live->endTrying();
        break;
    case State::practised:
        m_live->beginCounting();
        break;
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

bool TrialsScreen::isPage() const {
    return m_page->isVisible() &&
           (m_stage->currentWidget() == m_break || (m_card && m_stage->currentWidget() == m_card));
}

/// A key press within kOnePress_ms after the page has changed was meant for what it showed before, as is the
/// second press of two.
bool TrialsScreen::keysAreEarly() const {
    return m_page->isVisible() && m_changed.isValid() && m_changed.elapsed() < kOnePress_ms;
}

/// If the experimenter must come, or force was removed, continuing is not the only possible action.
bool TrialsScreen::goOnByKey() {
    if (!isPage())
        return false;
    const State state = m_live ? m_live->view().state : State::starting;
    if (m_begun && (state == State::needsExperimenter || state == State::stopped || state == State::starting))
        return true;
    if (m_card)
        go();
    else if (!m_break->readOn()) // to the end first, where the button is
        onBreakButton();
    return true;
}

void TrialsScreen::answer(int answer, std::optional<double> value) {
    if (!running())
        return;
    if (const auto taken = m_live->answer(answer, value); !taken)
        context().messages().error(tr("The answer was not accepted. Please answer again, and call the "
                                      "experimenter if this happens once more."),
                                   taken.error());
    m_answers->clear();
}

void TrialsScreen::mark() {
    if (running() && m_apex && m_live->view().canAnswer && !m_early.areEarly(m_clock.elapsed()))
        (void)m_live->answer(0); // if no answer is accepted any more, the trial has just ended
}

void TrialsScreen::pauseOrResume() {
    if (!running() || !m_begun || m_live->view().state == State::stopped)
        return; // when stopped, R is needed; before the start, the card
    m_live->view().state == State::paused ? m_live->resume() : m_live->pause();
}

/// Nothing is rendered while the instructions are read, so Esc asks to stop the session there. It also does
/// so if force has already been stopped.
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

void TrialsScreen::askToStop() {
    if (!running() || m_asking)
        return;
    m_asking = true;
    m_live->pause();
    freePointer();
    QMessageBox box(QMessageBox::Question, title(),
                    isPilot() ? tr("Stop this pilot run?") : tr("Stop this session?"), QMessageBox::NoButton,
                    m_window && !m_desk->isActiveWindow() ? m_window->window() : window());
    box.setObjectName(QStringLiteral("trials.ask"));
    box.setInformativeText(afterStopText());
    QPushButton* keep = box.addButton(tr("Go on with the trials"), QMessageBox::RejectRole);
    keep->setObjectName(QStringLiteral("trials.ask.keep"));
    QPushButton* stop = box.addButton(isPilot() ? tr("Stop the pilot run") : tr("Stop, and keep the answers"),
                                      QMessageBox::DestructiveRole);
    stop->setObjectName(QStringLiteral("trials.ask.stop"));
    box.setDefaultButton(keep);
    box.setEscapeButton(keep);
    const QPointer<TrialsScreen> here(this);
    box.exec();
    if (!here)
        return; // left meanwhile
    m_asking = false;
    m_changed.start();
    if (running() && !m_live->finished() && box.clickedButton() == stop)
        m_live->stop();
}

void TrialsScreen::finished() {
    over();
    m_sound.silence();
    freePointer();
    const core::Result<session::LiveStudyResult>& result = m_live->result();
    m_completed = result && result->completed;
    const bool asks = m_completed && ConditionQuestions::areIn(m_live->design());
    if (isPilot() && result && !m_completed && !result->endedByItself) {
        m_ended = endText(result);
        leave(); // whoever tried it was asked, and knows what becomes of it
    } else {
        asks ? askQuestions(endText(result)) : showEnd(endText(result));
    }
}

/// For the experimenter: how the session ended.
QString TrialsScreen::endText(const core::Result<session::LiveStudyResult>& result) const {
    if (!result)
        return tr("The session could not be run.") + QLatin1Char('\n') + inWords(result.error());
    if (result->completed)
        return isPilot() ? tr("The pilot run reached its end.") : tr("This condition is completed.");
    if (result->endedByItself)
        return tr("The session ended by itself before all trials were done, and nothing more was presented. "
                  "Check the device before you go on.") +
               QLatin1Char(' ') + afterStopText();
    return afterStopText();
}

void TrialsScreen::fail(const core::Error& error) {
    over();
    m_panel->showError(
        tr("The session could not be run"), error, [this] { leave(); }, Tried::saving);
}

/// This is not an error: it takes another device or another study.
void TrialsScreen::refuse(const QString& words) {
    over();
    m_panel->showEmpty(tr("Not possible with this device"), words,
                       triedStudy().isValid() ? tr("Back to the study")
                                              : tr("Back to the participant's conditions"),
                       [this] { leave(); });
}

void TrialsScreen::over() {
    m_over = true;
    m_frame.stop();
    m_keys->setActive(false);
    context().setTrialRuns(false);
}

QString TrialsScreen::refusalWords(const session::SittingError& error, const QLocale& locale) {
    if (error.device == session::DeviceRefusal::rendersNone)
        return tr("Because of its delay, this device can render none of the differences in this condition. "
                  "Use a faster or stronger "
                  "device, or plan another reference in another study.");
    if (error.device == session::DeviceRefusal::rendersLess)
        return tr("This run was started on a device that renders larger differences than this one. It can be "
                  "continued only with such a "
                  "device, so that all of its trials can be compared.");
    if (error.otherVersion)
        return tr("This run was started with a different version of its procedure. A run is never continued "
                  "with another version, so that "
                  "all of its trials can be compared. The answers so far are kept; enrol another participant "
                  "for this condition.");
    if (!error.tooStiff)
        return {};
    return tr("The sphere is too stiff for this device: the study asks for %1 N/m, but with its delay the "
              "device can render at most %2 N/m "
              "stably. Use a faster device, or plan a softer sphere in another study.")
        .arg(locale.toString(qRound(error.tooStiff->sphere_N_per_m)),
             locale.toString(qRound(error.tooStiff->device_N_per_m)));
}

std::vector<ScreenCommand> TrialsScreen::commands() {
    return {{tr("Experimenter"), QKeySequence(Qt::Key_F2), [this] { toggleExperimenter(); }, !running()},
            {tr("Pause or go on"), QKeySequence(Qt::Key_Space), [this] { pauseOrResume(); }, false},
            {felt_words::stop(rendersForce()), QKeySequence(Qt::Key_Escape), [this] { stopForce(); }, false},
            {felt_words::goOn(rendersForce()), QKeySequence(Qt::Key_R), [this] { rearm(); }, false},
            {tr("Stop the session"), {}, [this] { askToStop(); }, true}};
}

} // namespace chiron::desktop
