// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/widgets/logo.h"

#include "desktop/theme/theme.h"

#include <QLabel>

namespace chiron::desktop {

QIcon logoIcon() {
    return QIcon(QStringLiteral(":/theme/logo.svg"));
}

QLabel* logo(const Theme& theme, int size_px) {
    auto* sign = new QLabel;
    sign->setObjectName(QStringLiteral("logo"));
    sign->setAlignment(Qt::AlignCenter);
    sign->setPixmap(logoIcon().pixmap(theme.px(size_px), theme.px(size_px)));
    return sign;
}

} // namespace chiron::desktop
