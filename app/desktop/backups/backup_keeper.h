// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <chrono>
#include <functional>
#include <memory>

namespace chiron::desktop {

class AppContext;
class WorkToken;
struct Place;

/// Makes the day's backup by itself, off the GUI thread, once nobody has touched key, pointer or device for a while. Never while
/// a session or a study's sitting is open: one that is under way then stops at once and leaves nothing. What failed is told to
/// administrators and tried again, later each time. An event filter on the application. GUI thread.
class BackupKeeper final : public QObject {
    Q_OBJECT
public:
    static constexpr int kQuiet_ms = 5 * 60 * 1000;
    static constexpr int kLook_ms = 30 * 1000;

    BackupKeeper(AppContext& context, QObject* parent);

    void look(); ///< now, instead of with the next half-minute
    bool isRunning() const { return m_token != nullptr; }
    void setQuiet(int ms) { m_quiet_ms = ms; }
    /// How long to wait after so many failures one after the other.
    void setWaits(std::function<std::chrono::milliseconds(int failures)> waits) { m_waits = std::move(waits); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool mayBegin() const;
    void left(const Place& place);
    void stop();
    void failed(const QString& why);

    AppContext& m_context;
    QTimer m_timer;
    QElapsedTimer m_sinceTouch;
    QElapsedTimer m_sinceFailure; ///< by a clock that nobody sets
    int m_quiet_ms = kQuiet_ms;
    int m_failures = 0; ///< one after the other
    std::function<std::chrono::milliseconds(int)> m_waits;
    std::shared_ptr<WorkToken> m_token; ///< of the backup under way
};

} // namespace chiron::desktop
