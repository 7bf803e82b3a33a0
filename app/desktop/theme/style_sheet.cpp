// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/theme/theme.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace chiron::desktop {

namespace {

// In the sheet, @name is a colour of the theme, #12# a length at 100 %, #12-# that length minus one pixel.
// Widgets set the property "kind" to select their style. A border of 2 pixels instead of 1 takes the extra
// pixel from the padding, so that a focused widget keeps its size and no layout has to be recalculated.
constexpr const char* kSheet = R"(
QMainWindow, QDialog, QWidget[kind="page"] { background: @window; }
QScrollArea, QScrollArea > QWidget > QWidget[kind="page"] { background: @window; border: none; }
QFrame[kind="card"] { background: @surface; border: 1px solid @border; border-radius: #10#; }
QFrame[kind="raised"] { background: @raised; border: 1px solid @border; border-radius: #8#; }
QFrame[kind="good"] { background: @goodSoft; border: 1px solid @good; border-radius: #8#; }
QFrame[kind="warning"] { background: @warningSoft; border: 1px solid @warning; border-radius: #8#; }
QFrame[kind="bad"] { background: @badSoft; border: 1px solid @bad; border-radius: #8#; }
QFrame[kind="info"] { background: @accentSoft; border: 1px solid @accent; border-radius: #8#; }
QFrame[kind="rule"] { background: @border; border: none; max-height: 1px; min-height: 1px; }
QWidget[kind="sidebar"] { background: @sidebar; }
QWidget[kind="sidebar"] QLabel { color: @sidebarText; }
QWidget[kind="sidebar"] QPushButton { background: transparent; color: @sidebarText; border: 2px solid transparent;
    border-radius: #8#; padding: #8# #12#; text-align: left; }
QWidget[kind="sidebar"] QPushButton[compact="true"] { padding: #8# #4#; text-align: center; }
QWidget[kind="sidebar"] QScrollBar:vertical { background: @sidebar; }
QWidget[kind="sidebar"] QPushButton:hover { background: @sidebarActive; }
QWidget[kind="sidebar"] QPushButton:checked { background: @sidebarActive; font-weight: 600; border-left: #4# solid @accent; }
QWidget[kind="sidebar"] QPushButton:focus { border: 2px solid @focus; }
QWidget[kind="status"] { background: @surface; border-top: 1px solid @border; }
QWidget[kind="banner"] { background: @warningSoft; border-bottom: 1px solid @warning; }
QWidget[kind="banner"] QLabel { color: @warning; }
QLabel { color: @text; background: transparent; }
QLabel[kind="muted"] { color: @muted; }
QLabel[kind="good"] { color: @good; background: transparent; border: none; }
QLabel[kind="warning"] { color: @warning; background: transparent; border: none; }
QLabel[kind="bad"] { color: @bad; background: transparent; border: none; }
QLabel[kind="accent"] { color: @accent; }
QPushButton { background: @surface; color: @text; border: 1px solid @borderStrong; border-radius: #8#; padding: #6# #14#;
    min-height: #22#; }
QPushButton:hover { background: @accentSoft; border-color: @accent; }
QPushButton:pressed { background: @raised; }
QPushButton, QCheckBox, QRadioButton { outline: none; } /* the border shows the focus; the style's own frame would go through the words */
QPushButton:focus { border: 2px solid @focus; padding: #6-# #14-#; }
QPushButton:disabled { color: @muted; border-color: @border; background: @raised; }
QPushButton:checked { background: @accentSoft; border: 2px solid @accent; padding: #6-# #14-#; }
QPushButton[kind="primary"] { background: @accent; color: @accentText; border: 1px solid @accent; font-weight: 600; }
QPushButton[kind="primary"]:hover { background: @accentHover; }
QPushButton[kind="primary"]:focus { border: 2px solid @focus; }
QPushButton[kind="primary"]:disabled { background: @raised; color: @muted; border-color: @border; }
QPushButton[kind="danger"] { background: @danger; color: @dangerText; border: 1px solid @danger; font-weight: 600; }
QPushButton[kind="danger"]:focus { border: 2px solid @focus; }
QPushButton[kind="danger"]:disabled { background: @raised; color: @muted; border-color: @border; }
QPushButton[kind="quiet"] { background: transparent; border: 2px solid transparent; color: @accent; padding: #6-# #14-#; }
QPushButton[kind="quiet"]:hover { background: @accentSoft; }
QPushButton[kind="quiet"]:focus { border: 2px solid @focus; }
QPushButton[kind="tile"] { background: @surface; border: 1px solid @border; border-radius: #10#; padding: #14#; text-align: left; }
QPushButton[kind="tile"]:hover { border-color: @accent; background: @accentSoft; }
QPushButton[kind="tile"]:focus { border: 2px solid @focus; padding: #14-#; }
QPushButton[kind="tile"]:checked { border: 2px solid @accent; background: @accentSoft; padding: #14-#; }
QLineEdit, QPlainTextEdit, QTextEdit, QSpinBox, QDoubleSpinBox, QComboBox, QDateEdit { background: @surface; color: @text;
    border: 1px solid @borderStrong; border-radius: #6#; padding: #5# #8#; min-height: #22#; selection-background-color: @accent;
    selection-color: @accentText; }
QLineEdit:focus, QPlainTextEdit:focus, QTextEdit:focus, QSpinBox:focus, QDoubleSpinBox:focus, QComboBox:focus { border: 2px solid @focus;
    padding: #5-# #8-#; }
QLineEdit:disabled, QPlainTextEdit:disabled, QSpinBox:disabled, QDoubleSpinBox:disabled, QDateEdit:disabled, QComboBox:disabled { color: @muted; background: @raised; border-color: @border; }
QLineEdit[kind="bad"], QPlainTextEdit[kind="bad"], QSpinBox[kind="bad"], QDoubleSpinBox[kind="bad"], QComboBox[kind="bad"] { border: 2px solid @bad; padding: #5-# #8-#; }
QComboBox { combobox-popup: 0; }
QComboBox::drop-down { border: none; width: #24#; }
QComboBox::down-arrow { image: url(:/theme/chevron_%INK%.svg); width: #14#; height: #14#; margin-right: #8#; }
QComboBox::down-arrow:disabled { image: url(:/theme/chevron_%INK%_off.svg); }
QAbstractSpinBox::up-button { subcontrol-origin: border; subcontrol-position: top right; width: #16#; margin: 1px 1px 0 0; border: none;
    border-top-right-radius: #5#; background: transparent; }
QAbstractSpinBox::down-button { subcontrol-origin: border; subcontrol-position: bottom right; width: #16#; margin: 0 1px 1px 0; border: none;
    border-bottom-right-radius: #5#; background: transparent; }
QAbstractSpinBox::up-button:hover, QAbstractSpinBox::down-button:hover { background: @accentSoft; }
QAbstractSpinBox::up-button:pressed, QAbstractSpinBox::down-button:pressed { background: @raised; }
QAbstractSpinBox::up-arrow { image: url(:/theme/arrow_up_%INK%.svg); width: #9#; height: #9#; }
QAbstractSpinBox::down-arrow { image: url(:/theme/arrow_down_%INK%.svg); width: #9#; height: #9#; }
QAbstractSpinBox::up-arrow:disabled, QAbstractSpinBox::up-arrow:off { image: url(:/theme/arrow_up_%INK%_off.svg); }
QAbstractSpinBox::down-arrow:disabled, QAbstractSpinBox::down-arrow:off { image: url(:/theme/arrow_down_%INK%_off.svg); }
QComboBox QAbstractItemView, QComboBox QAbstractItemView:focus { background: @surface; color: @text; border: 1px solid @borderStrong; padding: 0;
    selection-background-color: @accent; selection-color: @accentText; outline: none; }
QCheckBox, QRadioButton { color: @text; spacing: #8#; background: transparent; padding: #3#; border: 2px solid transparent; border-radius: #6#; }
QCheckBox:focus, QRadioButton:focus { border: 2px solid @focus; }
QCheckBox::indicator, QRadioButton::indicator { width: #18#; height: #18#; border: 2px solid @borderStrong; background: @surface; }
QCheckBox::indicator { border-radius: #4#; }
QRadioButton::indicator { border-radius: #10#; }
QCheckBox::indicator:checked { background: @accent; border-color: @accent; image: url(:/theme/check_%ONACCENT%.svg); }
QRadioButton::indicator:checked { border-color: @accent; background: qradialgradient(cx: 0.5, cy: 0.5, radius: 0.5, fx: 0.5, fy: 0.5,
    stop: 0 @accent, stop: 0.55 @accent, stop: 0.62 @surface, stop: 1 @surface); }
QTableView, QListView, QTreeView, QTableWidget, QListWidget { background: @surface; color: @text; border: 1px solid @border; padding: 1px;
    border-radius: #8#; gridline-color: @grid; alternate-background-color: @raised; outline: none; selection-background-color: @accentSoft;
    selection-color: @text; }
QTableView::item, QListView::item { padding: #4# #8#; border: none; }
QTableView:focus, QListView:focus { border: 2px solid @focus; padding: 0; }
QTableView::item:selected, QListView::item:selected { background: @accentSoft; color: @text; }
QListView::item:selected { border-left: #3# solid @accent; }
QHeaderView { background: @raised; border: none; }
QHeaderView::section { background: @raised; color: @text; border: none; border-bottom: 1px solid @borderStrong; padding: #6# #8#; font-weight: 600; }
QTableCornerButton::section { background: @raised; border: none; }
QProgressBar { background: @raised; border: 1px solid @borderStrong; border-radius: #6#; text-align: center; color: @text; min-height: #18#; }
QProgressBar::chunk { background: @accentSoft; border: 1px solid @accent; border-radius: #5#; }
QSlider::groove:horizontal { background: @border; height: #6#; border-radius: #3#; }
QSlider::sub-page:horizontal { background: @accent; border-radius: #3#; }
QSlider::handle:horizontal { background: @accent; border: 2px solid @surface; width: #16#; margin: -#7# 0; border-radius: #9#; }
QSlider::handle:horizontal:focus { border: 2px solid @focus; }
QScrollBar:vertical { background: transparent; width: #12#; margin: 0; }
QScrollBar::handle:vertical { background: @borderStrong; border-radius: #5#; min-height: #30#; margin: #2#; }
QScrollBar:horizontal { background: transparent; height: #12#; margin: 0; }
QScrollBar::handle:horizontal { background: @borderStrong; border-radius: #5#; min-width: #30#; margin: #2#; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QTabBar::tab { background: transparent; color: @muted; padding: #8# #14#; border-bottom: #3# solid transparent; }
QTabBar::tab:selected { color: @text; border-bottom: #3# solid @accent; font-weight: 600; }
QTabBar::tab:focus { color: @focus; }
QTabBar::scroller { width: #56#; } /* of both buttons: each has half of it */
QTabWidget::pane { border: none; border-top: 1px solid @border; }
QToolTip { background: @raised; color: @text; border: 1px solid @borderStrong; padding: #4#; }
QMenu { background: @surface; color: @text; border: 1px solid @borderStrong; padding: #4#; }
QMenu::item { padding: #6# #18#; border-radius: #4#; }
QMenu::item:selected { background: @accentSoft; }
QSplitter::handle { background: @border; }
QGroupBox { border: 1px solid @border; border-radius: #8#; margin-top: #18#; padding: #10#; }
QGroupBox::title { subcontrol-origin: margin; left: #8#; color: @text; font-weight: 600; }
)";

QString inScale(QString sheet, const Theme& theme) {
    QString out;
    out.reserve(sheet.size());
    for (qsizetype i = 0; i < sheet.size(); ++i) {
        const qsizetype end = sheet.at(i) == QLatin1Char('#') ? sheet.indexOf(QLatin1Char('#'), i + 1) : -1;
        bool isLength = false;
        QString number = end > i + 1 && end <= i + 4 ? sheet.mid(i + 1, end - i - 1) : QString();
        const int less = number.endsWith(QLatin1Char('-')) ? 1 : 0;
        number.chop(less);
        const int length = number.toInt(&isLength);
        if (!isLength) {
            out += sheet.at(i);
            continue;
        }
        out += QStringLiteral("%1px").arg(theme.px(length) - less);
        i = end;
    }
    return out;
}

} // namespace

QString Theme::styleSheet() const {
    QString sheet = inScale(QString::fromLatin1(kSheet), *this);
    const auto drawing = [this](Colour ink) {
        return color(ink).lightness() > 128 ? QStringLiteral("light") : QStringLiteral("dark");
    };
    sheet.replace(QStringLiteral("%INK%"), drawing(Colour::text));
    sheet.replace(QStringLiteral("%ONACCENT%"), drawing(Colour::accentText));
    // Longer names come first, so that @accent does not replace the beginning of @accentSoft.
    std::vector<std::pair<QString, QColor>> names;
#define CHIRON_COLOUR(role) names.emplace_back(QStringLiteral("@" #role), color(Colour::role));
    CHIRON_THEME_COLOURS(CHIRON_COLOUR)
#undef CHIRON_COLOUR
    std::sort(names.begin(), names.end(),
              [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
    for (const auto& [name, colour] : names)
        sheet.replace(name, colour.name());
    return sheet;
}

} // namespace chiron::desktop
