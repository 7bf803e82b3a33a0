// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/navigator.h"

namespace chiron::desktop {

namespace {
constexpr std::size_t kLongestPast = 50;
}

void Navigator::go(const Place& place) {
    if (!mayLeave())
        return;
    if (!m_current.screen.isEmpty() && !(place == m_current)) {
        m_past.push_back(m_current);
        if (m_past.size() > kLongestPast)
            m_past.erase(m_past.begin());
    }
    m_current = place;
    emit moved(m_current);
}

void Navigator::replace(const Place& place) {
    if (mayLeave())
        replaceNow(place);
}

void Navigator::replaceNow(const Place& place) {
    m_current = place;
    emit moved(m_current);
}

void Navigator::back() {
    if (m_past.empty() || !mayLeave())
        return;
    m_current = m_past.back();
    m_past.pop_back();
    emit moved(m_current);
}

} // namespace chiron::desktop
