// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/plot_theme.h"

#include <QFontDatabase>
#include <QStringList>

namespace chiron::report {

QFont PlotTheme::font(double pixels, bool bold) const {
    QFont font;
    // The families after the first one supply letters that it lacks.
    font.setFamilies({family, QStringLiteral("Noto Sans"), QStringLiteral("DejaVu Sans")});
    font.setPixelSize(qMax(1, qRound(pixels * scale)));
    font.setWeight(bold ? QFont::DemiBold : QFont::Normal);
    // Letters keep their true widths at any scale of the paper.
    font.setHintingPreference(QFont::PreferNoHinting);
    // With any extra space between letters, Qt forms no ligatures; ligatures would be copied as characters of
    // their own.
    if (copied)
        font.setLetterSpacing(QFont::AbsoluteSpacing, 1.0 / 64.0);
    return font;
}

QString reportFontFamily() {
    const QStringList installed = QFontDatabase::families();
    for (const char* wanted : {"Noto Sans", "DejaVu Sans", "Inter"}) {
        if (installed.contains(QLatin1String(wanted)))
            return QLatin1String(wanted);
    }
    return QFont().family();
}

PlotTheme lightTheme(const QLocale& locale) {
    PlotTheme theme;
    theme.family = reportFontFamily();
    theme.copied = true;
    theme.locale = locale;
    return theme;
}

} // namespace chiron::report
