// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"
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

/// One sitting of one participant at one condition. The participant's page (no value, level, condition or estimate: places to compare, or the
/// scene in which an apex is looked for) fills a window of its own where there is a second screen, and the experimenter's desk this one; with
/// one screen the page fills this window, and the desk comes in its place for the experimenter alone: where the study blinds anybody with
/// their password. Each trial is stored as it is answered; leaving keeps the run, which is resumed at the trial. Place: {study, participant,
/// condition}; without a condition the participant's next one; with "one_screen" true a second screen is left alone; "free_minute_s" is another length of the
/// free minute. GUI thread.
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

    session::LiveSitting* live() const { return m_live.get(); } ///< null before it begins
    bool atDesk() const; ///< the experimenter's desk is in this window
    ParticipantWindow* participantWindow() const { return m_window; } ///< null with one screen

    /// Why the device is not taken, in the language of the program; empty where it is refused for something else.
    static QString refusalWords(const session::SittingError& error, const QLocale& locale);

    /// Why a trial does not count, as a participant is told it; whether an answer was right is not in it. `pulls`: objects are taken hold of.
    static QString repeatedWords(const std::string& reason, bool pulls, double probe_N, const QLocale& locale);

private:
    // trials_screen_build.cpp
    void buildPage();
    void buildDesk();
    QWidget* buildHead();
    QWidget* buildStage();
    QWidget* buildStrip();
    void buildLive(); ///< what depends on the task, once it is known
    void buildPlaces();
    void buildApex();
    void buildKeys();
    void toolKey(int key, bool down);
    void connectPointer();
    QWidget& area();   ///< of the scene
    QObject& source(); ///< of its mouse and keys

    // trials_screen_show.cpp
    void showState(const session::LiveStudyView& view);
    void showScene(const session::LiveStudyView& view);
    void showBreak(const session::LiveStudyView& view);
    QString whyNoAnswer(const session::LiveStudyView& view) const;
    QString apexWords(const session::LiveStudyView& view) const;
    QString stoppedText() const;
    QString triedText() const;
    QString trialText(const session::LiveStudyView& view) const; ///< "Trial 3 of 12"; nothing of how the procedure stands
    QString repeatedText(const session::LiveStudyView& view) const;
    QString comesAgainText() const;

    void showStrip(const session::LiveStudyView& view);
    void hearMasking(bool scene);
    void showSilence(); ///< to the experimenter alone

    // trials_screen_desk.cpp: who sees what, and who may go on
    void placePage();
    void bringBack(); ///< the participant's screen is gone
    bool guarded() const;
    bool isPilot() const { return m_live && !m_live->design().pilotOf.empty(); }
    void callExperimenter(std::function<void()> then);
    void showDesk();
    void showPage();
    void askQuestions(const QString& what); ///< what the study asks after each condition, on the participant's page; showEnd() follows
    void showEnd(const QString& what);
    void clearHead(const QString& note); ///< of what only belongs to a sitting; the experimenter may go on
    void leave();

    // trials_screen.cpp
    void begin();
    void showInstructions();
    void showWholeInstructions();
    QString partText() const;
    QString furtherPartText() const;
    void showCard();
    void go();
    void stripAction(); ///< the free minute, or the feedback of practice, was long enough
    void poll();
    void onBreakButton();
    bool goOnByKey(); ///< Enter or Space, on a page where going on is the only thing to do; false where the key means something else
    bool isPage() const; ///< something to read, no trial
    void answer(int answer, std::optional<double> value);
    void mark(); ///< "here it is", of an apex
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
    bool running() const { return m_live && !m_over; }

    QString m_participant;
    std::string m_condition;
    database::StudyNumber m_study;
    StatePanel* m_panel = nullptr;
    QStackedWidget* m_faces = nullptr; ///< of this window: the participant's page, the experimenter's desk
    QWidget* m_page = nullptr;
    QWidget* m_desk = nullptr;
    ParticipantWindow* m_window = nullptr;
    QLabel* m_deskNote = nullptr;
    QWidget* m_noSound = nullptr; ///< at the desk: masking sound is asked for and not heard
    QPushButton* m_toPage = nullptr;
    QPushButton* m_leave = nullptr;
    ReadyCard* m_card = nullptr;
    QLabel* m_strip = nullptr;
    QLabel* m_repeated = nullptr; ///< why the trial before did not count; empty where it did
    QPushButton* m_takeBack = nullptr;
    QPushButton* m_enough = nullptr;
    QStackedWidget* m_stage = nullptr;
    BreakPanel* m_break = nullptr;
    ConditionQuestions* m_questions = nullptr; ///< null until a condition is done after which something is asked
    QWidget* m_trial = nullptr;
    PlacesView* m_places = nullptr;   ///< null where an apex is looked for
    AnswerPanel* m_answers = nullptr; ///< as m_places
    ApexStage* m_apex = nullptr;      ///< null where places are compared
    QLabel* m_note = nullptr;
    QProgressBar* m_progress = nullptr;
    QProgressBar* m_time = nullptr;
    ExperimenterPanel* m_experimenter = nullptr;
    QPushButton* m_call = nullptr; ///< the experimenter, from the participant's page
    QPushButton* m_stop = nullptr;
    KeyFilter* m_keys = nullptr;
    SoundCuePlayer m_sound{4.0};
    bool m_masking = true;
    bool m_released = false;  ///< the experimenter goes on elsewhere
    bool m_gate = false;      ///< their password is asked for
    QString m_ended;          ///< what became of the sitting, for the experimenter
    bool m_completed = false;
    bool m_over = false;
    bool m_asking = false;
    bool m_begun = false; ///< the instructions were read
    session::LiveStudyView::State m_state = session::LiveStudyView::State::starting;
    QElapsedTimer m_pageCame; ///< by itself, where something else was at hand
    QElapsedTimer m_wentOn;   ///< by a key
    QTimer m_frame;
    std::unique_ptr<session::LiveSitting> m_live;
    int m_sessions = 0; ///< whose pointer is connected
    std::unique_ptr<HandControl> m_hand;
    std::unique_ptr<ScenePointer> m_pointer;
};

} // namespace chiron::desktop
