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

/// Locks the window: when nobody has touched anything for ten minutes, or when asked (Ctrl+L); never while a trial runs.
/// While locked nothing of the program can be seen or reached (other windows of it are hidden, keys go to the cover only),
/// and nothing that is under way is stopped. Lives as long as the window. GUI thread.
class LockController final : public QObject {
    Q_OBJECT
public:
    LockController(AppContext& context, QMainWindow& window);

    IdleLock& idleLock() { return m_idle; }
    bool isLocked() const { return m_cover != nullptr; }
    void lock(); ///< nothing happens where nobody is logged in, or a trial runs

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
    std::vector<QPointer<QWidget>> m_hidden; ///< other windows, shown again afterwards
};

} // namespace chiron::desktop
