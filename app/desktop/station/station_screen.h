// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/station_repository.h"
#include "desktop/frame/background.h"
#include "desktop/frame/screen.h"
#include "desktop/station/station_facts.h"
#include "desktop/station/station_record.h"
#include "session/loop_self_test.h"

#include <functional>
#include <optional>

class QPushButton;
class QTimer;
class QVBoxLayout;

namespace chiron::desktop {

class PlatformCard;
class StatePanel;
class TaskStrip;

/// Shows the condition of this station: devices, punctuality of the force loop in the last session and in a
/// self-test, real-time priority, P3's verification of the fingertip platform, free space. Everybody may
/// look. People whom the data layer allows to check stations can run the self-test and the verification, but
/// not while a session runs. Each check is stored in the audit trail and has a record to file.
class StationScreen final : public Screen {
    Q_OBJECT
public:
    /// The place's parameters are "self_test_ms", the length of the self-test (default 10 s), and
    /// "verify_poses", the number of poses in the platform's verification. Without "verify_poses" the
    /// verification uses 100 poses and adds the table of degraded parts.
    StationScreen(AppContext& context, const Place& place);
    ~StationScreen() override; ///< ends a running self-test

    QString title() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;
    QString help() const override;
    /// Errors: wrongUse if there is no check yet; storage.
    core::Result<void> writePlatformRecord(const QString& path) const;
    core::Result<void> writeLoopRecord(const QString& path) const; ///< the same for the self-test

signals:
    void selfTestEnded();
    void verificationEnded();
    void checkNoted(); ///< the check was stored in the audit trail, or could not be

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

    // station_platform.cpp
    PlatformCard* platformCard();
    void startVerification();
    void askRecord();
    /// The time at which a check ended, and its entry in the audit trail.
    struct CheckedAt {
        QDateTime when;
        std::int64_t entry = 0;
        QString site{};
    };
    bool mayCheck() const;
    void note(const database::StationCheck& check, CheckedAt* at);
    CheckCircumstances circumstances(const CheckedAt& at, const QString& device,
                                     const std::optional<QString>& serial) const;
    void saveRecord(const QString& name, std::function<core::Result<void>(const QString&)> write);

    StatePanel* m_panel;
    TaskStrip* m_strip;
    QTimer* m_timer;
    QPushButton* m_test = nullptr;
    QPushButton* m_testRecord = nullptr;
    std::optional<session::SelfTestResult> m_tested;
    CheckedAt m_loopChecked;
    CheckedAt m_platformChecked;
    QString m_platformSerial; ///< empty if not reported
    PlatformCard* m_platform = nullptr;
    QVBoxLayout* m_testBox = nullptr;
    std::shared_ptr<session::SelfTestTask> m_task;
    std::shared_ptr<WorkToken> m_token;
};

} // namespace chiron::desktop
