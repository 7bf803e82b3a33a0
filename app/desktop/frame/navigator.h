// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/place.h"

#include <QObject>
#include <functional>
#include <vector>

namespace chiron::desktop {

/// Where the program is and was. Screens ask to go somewhere; the main window listens and builds the screen. GUI thread.
class Navigator : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    const Place& current() const noexcept { return m_current; }
    bool canGoBack() const noexcept { return !m_past.empty(); }
    /// Asks to go there; what is now becomes the past. Nothing happens where the present screen may not be left.
    void go(const Place& place);
    void go(const QString& screen, const QVariantMap& parameters = {}) { go(Place{screen, parameters}); }
    /// The same without a past: for screens that nobody returns to (training -> debrief, login -> home).
    void replace(const Place& place);
    /// replace() that asks nobody.
    void replaceNow(const Place& place);
    void back();
    /// Forgets the past: after login and logout.
    void forget() { m_past.clear(); }
    /// The present screen now shows something else (a filter, a moment); it is not built anew.
    void note(const QVariantMap& parameters) { m_current.parameters = parameters; }

    /// Asked before the present screen is left; set by the main window.
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
