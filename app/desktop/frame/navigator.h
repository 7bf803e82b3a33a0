// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/place.h"

#include <QObject>
#include <functional>
#include <vector>

namespace chiron::desktop {

/// Keeps the current place and the history of places. Screens ask to go somewhere; the main window listens
/// and builds the screen.
/// Thread: GUI.
class Navigator : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    const Place& current() const noexcept { return m_current; }
    bool canGoBack() const noexcept { return !m_past.empty(); }
    /// Goes to a place and adds the current one to the history. Does nothing if the current screen may not be
    /// left.
    void go(const Place& place);
    void go(const QString& screen, const QVariantMap& parameters = {}) { go(Place{screen, parameters}); }
    /// The same without adding to the history, for screens that nobody returns to (training -> debrief, login
    /// -> home).
    void replace(const Place& place);
    /// The same as replace(), but without asking whether the current screen may be left.
    void replaceNow(const Place& place);
    void back();
    /// Clears the history, after login and logout.
    void forget() { m_past.clear(); }
    /// Records that the current screen now shows something else (a filter, a moment), without rebuilding it.
    void note(const QVariantMap& parameters) { m_current.parameters = parameters; }

    /// The guard is asked before the current screen is left. The main window sets it.
    void setGuard(std::function<bool()> mayLeave) { m_mayLeave = std::move(mayLeave); }

signals:
    void moved(const chiron::desktop::Place& place);

private:
    bool mayLeave() const { return !m_mayLeave || m_mayLeave(); }

    Place m_current;
    std::vector<Place> m_past;
    std::function<bool()> m_mayLeave;
};

} // namespace chiron::desktop
