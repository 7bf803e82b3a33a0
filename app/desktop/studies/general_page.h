// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/study_page.h"

#include <QWidget>

namespace chiron::desktop {

/// What a new study of no template holds where its aim belongs: nobody's aim.
inline constexpr const char* kPlaceholderAim = "What is to be found out.";
bool isPlaceholderAim(const QString& aim);

/// What a study is about, who approved it, and what participants agree to. GUI thread.
class GeneralPage final : public QWidget {
    Q_OBJECT
public:
    explicit GeneralPage(const DesignPage& page, QWidget* parent = nullptr);

private:
    QWidget* aimBox(const DesignPage& page);
    void addAim(FieldGrid& grid, const DesignPage& page);
    QWidget* ethicsBox(const DesignPage& page);
};

} // namespace chiron::desktop
