// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QLocale>
#include <QString>

namespace chiron::report {

/// Colours, fonts and number locale of plots and pages. All colours are opaque, because PDF/A-1b does not
/// allow transparency. The contrast of every ink against the paper is at least 4.5:1.
struct PlotTheme {
    QColor paper{255, 255, 255};
    QColor ink{27, 38, 49};
    QColor muted{92, 104, 117};
    QColor rule{208, 214, 221};
    QColor grid{232, 236, 240};
    QColor panel{245, 247, 249};
    QColor accent{0, 95, 135};
    QColor good{20, 110, 70};
    QColor bad{176, 32, 36};
    QColor warning{138, 84, 0};
    QColor goodFill{223, 240, 231};
    QColor badFill{250, 226, 224};
    QColor warningFill{253, 240, 213};
    QColor overFill{244, 170, 164}; ///< fill under the part of a line that exceeds its limit
    QColor seriesA{0, 95, 135};     ///< solid line
    QColor seriesB{178, 84, 0};     ///< dashed line
    QColor seriesC{86, 58, 140};    ///< dotted line
    QColor seriesD{92, 104, 117};   ///< dash-dotted line: a second session for comparison
    double scale = 1.0;             ///< scale of the fonts and of the minimum size, 1..2; 1 on paper
    QString family;                 ///< set from reportFontFamily()
    bool copied = false;            ///< for paper from which text is copied
    QLocale locale = QLocale(QLocale::English, QLocale::UnitedKingdom);

    /// A font of `pixels` logical pixels (1/96 inch) times the scale. Sizes are in pixels so that screen, PNG
    /// and PDF agree.
    QFont font(double pixels, bool bold = false) const;
};

/// Returns the first installed family of Noto Sans, DejaVu Sans and Inter, or the application's own font if
/// none is installed. Inter comes last because it draws colons, brackets and minus signs between digits with
/// glyphs that have no character code, so they would be missing from text copied from a PDF.
/// Thread: GUI.
QString reportFontFamily();

/// The light theme of printed reports, in the given locale.
PlotTheme lightTheme(const QLocale& locale);

} // namespace chiron::report
