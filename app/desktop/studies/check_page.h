// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/check_list.h"
#include "desktop/studies/study_jobs.h"

namespace chiron::desktop {

/// The last page of a draft: the checks before freezing, the pilot, and freezing itself.
/// Thread: GUI.
class CheckPage final : public QWidget {
    Q_OBJECT
public:
    CheckPage(const DesignPage& page, const OpenStudy& study, const std::vector<DesignFault>& faults,
              QWidget* parent = nullptr);

signals:
    void goAsked(const chiron::desktop::FreezeCheck& check);
    void pilotAsked();
    void freezeAsked();

private:
    QWidget* checksBox(const std::vector<DesignFault>& faults);
    QWidget* pilotBox();
    QWidget* freezeBox();

    DesignPage m_page;
    const OpenStudy& m_study;
};

} // namespace chiron::desktop
