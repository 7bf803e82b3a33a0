// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QFrame>
#include <memory>

class QLabel;
class QProgressBar;
class QPushButton;
class QTimer;

namespace chiron::desktop {

class WorkToken;

/// Shows a running long task: description, progress, Cancel. It is hidden otherwise.
/// Thread: GUI.
class TaskStrip final : public QFrame {
    Q_OBJECT
public:
    explicit TaskStrip(const Theme& theme, QWidget* parent = nullptr);
    /// Without a token the task cannot be cancelled and its progress is unknown.
    void start(const QString& what, std::shared_ptr<WorkToken> token = {});
    void stop();
    bool isRunning() const noexcept { return m_running; }

private:
    void update();

    QLabel* m_text;
    QProgressBar* m_bar;
    QPushButton* m_cancel;
    QTimer* m_timer;
    std::shared_ptr<WorkToken> m_token;
    bool m_running = false;
};

} // namespace chiron::desktop
