// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/participant_page.h"

namespace chiron::desktop {

/// Qt calls this for a Tab as well as for a control that is disabled or hidden, and only then is the focus on
/// a control that cannot take it.
bool ParticipantPage::focusNextPrevChild(bool next) {
    const QWidget* had = window()->focusWidget();
    const bool lost = isVisible() && had && isAncestorOf(had) && !(had->isEnabled() && had->isVisible());
    if (!lost)
        return QWidget::focusNextPrevChild(next);
    setFocus(Qt::OtherFocusReason);
    return true;
}

} // namespace chiron::desktop
