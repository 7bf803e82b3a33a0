// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"
#include "desktop/study_run/study_controls.h"
#include "desktop/training/early_marks.h"
#include "desktop/training/hand_control.h"
#include "desktop/training/scene_pointer.h"
#include "desktop/training/sound_cue_player.h"
#include "session/study/live_sitting.h"

#include <QElapsedTimer>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace chiron::desktop {

class AnswerPanel;
class ApexStage;
class BreakPanel;
class ConditionQuestions;
class ExperimenterPanel;
class KeyFilter;
class ParticipantWindow;
class PlacesView;
class ReadyCard;
class StatePanel;

/// One session of one participant in one condition of a study. The participant's page shows no value, level,
/// condition or estimate: only the places to compare, or the scene of the apex search. With a second screen
/// the page fills a window there, and the experimenter's desk is in this window. With one screen the page
/// fills this window; the desk replaces it for the experimenter only, and if the study blinds anybody, only
/// with their password. Each trial is stored when it is answered. Leaving the screen keeps the run, which
/// resumes at the same trial. The place is {study, participant, condition}; without a condition it is the
/// participant's next one. "one_screen": true ignores a second screen; "free_minute_s" changes the length of
/// the free minute.
/// Thread: GUI.
class TrialsScreen final : public Screen {
    Q_OBJECT
public:
    TrialsScreen(AppContext& context, const Place& place);
    ~TrialsScreen() override;

    QString title() const override;
    QString help() const override;
    void enter() override;
    bool mayLeave() override;
    bool isBusy() const override { return running(); }
    std::vector<ScreenCommand> commands() override;

    session::LiveSitting* live() const { return m_live.get(); } ///< null before it starts
    bool atDesk() const; ///< whether the experimenter's desk is in this window
    ParticipantWindow* participantWindow() const { return m_window; } ///< null with one screen

    /// Why the device is not accepted, in the program's language; empty if the session was refused for
    /// another reason.
    static QString refusalWords(const session::SittingError& error, const QLocale& locale);

    /// The participant's explanation why a trial does not count. It does not reveal whether the answer was
    /// right.
    static QString repeatedWords(const std::string& reason, session::LiveStudyView::Missed missed,
                                 Handling handling, double probe_N, const QLocale& locale);

private:
    // trials_screen_build.cpp
    void buildPage();
    void buildDesk();
    QWidget* buildHead();
    QWidget* buildStage();
    QWidget* buildStrip();
    void buildLive(); ///< the parts that depend on the task, once it is known
    void buildPlaces();
    void buildApex();
    void buildKeys();
    void toolKey(int key, bool down);
    void connectPointer();
    bool isLarge() const; ///< texts are so large that the scene needs the room of all that is empty
    QWidget& area();      ///< area of the scene
    QObject& source();    ///< source of the scene's mouse and key events

    // trials_screen_show.cpp
    void showState(const session::LiveStudyView& view);
    void showScene(const session::LiveStudyView& view);
    void showBreak(const session::LiveStudyView& view);
    QString whyNoAnswer(const session::LiveStudyView& view) const;
    QString exploringWords(const session::LiveStudyView& view) const;
    QString apexWords(const session::LiveStudyView& view) const;
    QString holdWords(const session::LiveStudyView& view) const;
    QString tryingWords(const session::LiveStudyView& view) const;
    QString hardnessHow() const;
    QString meetWords(const session::LiveStudyView& view) const;
    QString pointerWords(const session::LiveStudyView& view) const;
    QString missingWords(const session::LiveStudyView& view) const;
    /// What to do if the hand uses, or in this trial has used, nearly the largest force allowed; otherwise
    /// empty.
    QString gentlerText(const session::LiveStudyView& view) const;
    QString stoppedText() const;
    QString afterStopText() const;
    QString endText(const core::Result<session::LiveStudyResult>& result) const;
    QString triedText() const;
    QString countingText() const;
    QString needsText(const session::LiveStudyView& view) const;
    void cameByItself();
    /// Whether a key may still be meant for what the page showed before it changed.
    bool keysAreEarly() const;
    /// What the participant reads at the end: whether they are done, what comes next, and who decides.
    void sayEnd();
    /// "Trial 3 of 12"; does not reveal the state of the procedure.
    QString trialText(const session::LiveStudyView& view) const;
    QString repeatedText(const session::LiveStudyView& view) const;
    QString comesAgainText() const;
    QString takeBackText(const session::LiveStudyView& view) const;

    void showStrip(const session::LiveStudyView& view);
    void hearMasking(bool scene);
    bool noisePlays() const; ///< whether the participant hears the masking noise during the trials
    void showSilence();      ///< visible to the experimenter only

    // trials_screen_desk.cpp: who sees what, and who may continue
    void placePage();
    void bringBack(); ///< the participant's screen has disappeared
    bool guarded() const;
    bool isPilot() const { return m_live && !m_live->design().pilotOf.empty(); }
    QVariant triedStudy() const; ///< the number of the draft that a pilot tries; invalid if this is no pilot
    void callExperimenter(std::function<void()> then);
    void showDesk();
    void showPage();
    void returnKeys();
    /// Asks the questionnaires after the condition, on the participant's page; showEnd() follows.
    void askQuestions(const QString& what);
    void showEnd(const QString& what);
    /// Removes what is only needed during the session; the experimenter may leave.
    void clearHead(const QString& note);
    void leave();

    // trials_screen.cpp
    void begin();
    void showInstructions();
    void showWholeInstructions();
    void showPageToRead(); ///< the page of m_break, which takes no key that was meant for the one before
    void sayWholeInstructions(); ///< again after a change of what they say
    QString partText() const;
    QString furtherPartText() const;
    void showCard();
    void go();
    void stripAction(); ///< ends the free minute, or the feedback of practice, early
    void poll();
    void onBreakButton();
    /// Enter or Space on a page where continuing is the only action. Returns false if the key has another
    /// meaning.
    bool goOnByKey();
    Handling handling() const;
    StudyHand hand() const;
    bool rendersForce() const;
    QString participantCode() const;
    LetGo letGo() const;
    bool isPage() const; ///< a page to read, not a trial
    void answer(int answer, std::optional<double> value);
    void mark(); ///< marks the apex ("here it is")
    void pauseOrResume();
    void stopForce();
    void rearm();
    void askToStop();
    void finished();
    void fail(const core::Error& error);
    void refuse(const QString& words);
    void over();
    void toggleExperimenter();
    void freePointer();
    void capturePointer();
    /// Longer than a double press, and than it takes to notice a page.
    static constexpr int kOnePress_ms = 600;
    bool running() const { return m_live && !m_over; }

    QString m_participant;
    std::string m_condition;
    database::StudyNumber m_study;
    StatePanel* m_panel = nullptr;
    /// Pages of this window: the participant's page, the experimenter's desk.
    QStackedWidget* m_faces = nullptr;
    QWidget* m_page = nullptr;
    QWidget* m_desk = nullptr;
    ParticipantWindow* m_window = nullptr;
    QLabel* m_deskNote = nullptr;
    QWidget* m_noSound = nullptr; ///< at the desk: masking sound is required but not audible
    QPushButton* m_toPage = nullptr;
    QPushButton* m_leave = nullptr;
    ReadyCard* m_card = nullptr;
    QLabel* m_strip = nullptr;
    QLabel* m_repeated = nullptr; ///< why the previous trial did not count; empty if it did
    QPushButton* m_takeBack = nullptr;
    QPushButton* m_enough = nullptr;
    QStackedWidget* m_stage = nullptr;
    BreakPanel* m_break = nullptr;
    /// Null until a condition with questions after it is completed.
    ConditionQuestions* m_questions = nullptr;
    QWidget* m_trial = nullptr;
    PlacesView* m_places = nullptr;   ///< null for an apex search
    AnswerPanel* m_answers = nullptr; ///< null for an apex search
    ApexStage* m_apex = nullptr;      ///< null if places are compared
    QLabel* m_note = nullptr;
    QProgressBar* m_progress = nullptr;
    QProgressBar* m_time = nullptr;
    ExperimenterPanel* m_experimenter = nullptr;
    QPushButton* m_call = nullptr; ///< calls the experimenter from the participant's page
    QPushButton* m_stop = nullptr;
    KeyFilter* m_keys = nullptr;
    SoundCuePlayer m_sound{4.0};
    bool m_masking = true;
    bool m_released = false; ///< the experimenter has left for another screen
    bool m_gate = false;     ///< the experimenter's password is being asked for
    QString m_ended;         ///< result of the session, for the experimenter
    bool m_completed = false;
    bool m_over = false;
    bool m_asking = false;
    bool m_begun = false; ///< the instructions have been read
    bool m_whole = false; ///< the whole instructions are, or were, on the page
    session::LiveStudyView::State m_state = session::LiveStudyView::State::starting;
    /// Time since what Enter and Space do on the page has changed, by itself or by a key press.
    QElapsedTimer m_changed;
    EarlyMarks m_early;
    QElapsedTimer m_clock;      ///< runs since the screen was made
    bool m_hasLetGo = false;    ///< of an object, in the free minute
    bool m_pausedByKey = false; ///< the participant has just paused: the page that comes is no surprise
    QTimer m_frame;
    std::unique_ptr<session::LiveSitting> m_live;
    int m_sessions = 0; ///< session whose pointer is connected
    std::unique_ptr<HandControl> m_hand;
    std::unique_ptr<ScenePointer> m_pointer;
};

} // namespace chiron::desktop
