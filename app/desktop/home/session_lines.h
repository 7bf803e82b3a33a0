// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/app_context.h"
#include "desktop/sessions/session_row.h"

#include <QWidget>
#include <vector>

namespace chiron::desktop {

/// Lists a few sessions, one button per line: exercise, date, and the outcome as icon and text. A button
/// opens the debrief.
class SessionLines final : public QWidget {
    Q_OBJECT
public:
    /// `names`: show whose session it is.
    SessionLines(AppContext& context, const std::vector<SessionRow>& rows, bool names,
                 QWidget* parent = nullptr);

private:
    QWidget* line(const SessionRow& row, bool names);
    AppContext& m_context;
};

} // namespace chiron::desktop
