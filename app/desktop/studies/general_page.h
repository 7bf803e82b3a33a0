// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/study_page.h"

#include <QWidget>

namespace chiron::desktop {

/// The placeholder that a new study without a template contains as its aim.
inline constexpr const char* kPlaceholderAim = "What is to be found out.";
bool isPlaceholderAim(const QString& aim);

/// Edits the aim of a study, its ethics approval, and the consent text for participants.
/// Thread: GUI.
class GeneralPage final : public QWidget {
    Q_OBJECT
public:
    explicit GeneralPage(const DesignPage& page, QWidget* parent = nullptr);

private:
    QWidget* aimBox(const DesignPage& page);
    void addAim(FieldGrid& grid, const DesignPage& page);
    QWidget* consentBox(const DesignPage& page);
};

} // namespace chiron::desktop
