// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "desktop/lock/idle_lock.h"

#include <QMainWindow>
#include <QPointer>
#include <vector>

namespace chiron::desktop {

class AppContext;
class LockCover;

/// Locks the window after ten minutes without input, or on request (Ctrl+L), but never while a trial runs.
/// While it is locked, nothing of the program can be seen or reached: other windows are hidden and keys go to
/// the cover only. Work in progress continues. The controller lives as long as the window.
/// Thread: GUI.
class LockController final : public QObject {
    Q_OBJECT
public:
    LockController(AppContext& context, QMainWindow& window);

    IdleLock& idleLock() { return m_idle; }
    bool isLocked() const { return m_cover != nullptr; }
    void lock(); ///< does nothing if nobody is logged in or a trial runs

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void cover();
    void uncover();
    void tryUnlock(const QString& password);
    void switchUser();
    void hideOthers();
    bool mayPass(QObject* watched, const QEvent& event) const;

    AppContext& m_context;
    QMainWindow& m_window;
    IdleLock m_idle;
    LockCover* m_cover = nullptr;
    QString m_titleBefore;
    QPointer<QWidget> m_focusBefore;
    std::vector<QPointer<QWidget>> m_hidden; ///< other windows, shown again on unlock
};

} // namespace chiron::desktop
