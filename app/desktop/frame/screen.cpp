// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/screen.h"

#include "desktop/frame/app_context.h"

namespace chiron::desktop {

Screen::Screen(AppContext& context, const Place& place, QWidget* parent)
    : QWidget(parent), m_context(context), m_place(place) {
    setObjectName(QStringLiteral("screen.") + place.screen);
    setProperty("kind", QStringLiteral("page"));
    setAttribute(Qt::WA_StyledBackground);
}

} // namespace chiron::desktop
