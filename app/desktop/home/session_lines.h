// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/app_context.h"
#include "desktop/sessions/session_row.h"

#include <QWidget>
#include <vector>

namespace chiron::desktop {

/// A few sessions, one button a line: what it was, when, and what it came to, by sign and word. A button opens the debrief.
class SessionLines final : public QWidget {
    Q_OBJECT
public:
    /// `names`: say whose session it is.
    SessionLines(AppContext& context, const std::vector<SessionRow>& rows, bool names, QWidget* parent = nullptr);

private:
    QWidget* line(const SessionRow& row, bool names);
    AppContext& m_context;
};

} // namespace chiron::desktop
