// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/background.h"
#include "desktop/frame/screen.h"
#include "desktop/station/station_facts.h"
#include "session/loop_self_test.h"

class QPushButton;
class QTimer;
class QVBoxLayout;

namespace chiron::desktop {

class StatePanel;
class TaskStrip;

/// How fit this station is: devices, punctuality of the force loop in the last session and in a self-test, real-time priority,
/// room. Everybody may look; administrators run the self-test, never while a session runs.
class StationScreen final : public Screen {
    Q_OBJECT
public:
    /// Parameter "self_test_ms": length of the self-test, 10 s where it is absent.
    StationScreen(AppContext& context, const Place& place);
    ~StationScreen() override; ///< ends a self-test

    QString title() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;
    QString help() const override;

signals:
    void selfTestEnded();

private:
    void load();
    void show(const StationFacts& facts);
    QWidget* devicesCard() const;
    QWidget* loopCard(const StationFacts& facts);
    QWidget* roomCard(const StationFacts& facts) const;
    void addLoop(QVBoxLayout& column, const session::LoopReport& loop) const;
    void startSelfTest();
    void showSelfTest(const session::SelfTestResult& result);
    void showButton();

    StatePanel* m_panel;
    TaskStrip* m_strip;
    QTimer* m_timer;
    QPushButton* m_test = nullptr;
    QVBoxLayout* m_testBox = nullptr;
    std::shared_ptr<session::SelfTestTask> m_task;
    std::shared_ptr<WorkToken> m_token;
};

} // namespace chiron::desktop
