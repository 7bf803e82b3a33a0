// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QLocale>
#include <QString>
#include <QVariant>
#include <QWidget>
#include <functional>
#include <utility>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLineEdit;
class QPlainTextEdit;
class QSpinBox;

namespace chiron::desktop {

/// Numbers that a field takes, and how they are written.
struct NumberRange {
    double minimum = -1e9;
    double maximum = 1e9;
    int decimals = 3;
    QString unit;
    double step = 0.0; ///< 0: a tenth of what decimals show
};

/// Fields under their labels in as many columns as the width has room for. Each calls back when it is changed by a person, never when it
/// is filled. Read-only grids show the same fields, which cannot be changed. GUI thread.
class FieldGrid : public QWidget {
    Q_OBJECT
public:
    FieldGrid(const Theme& theme, const QLocale& locale, bool readOnly, QWidget* parent = nullptr);

    QDoubleSpinBox* number(const QString& label, const QString& name, double value, const NumberRange& range, std::function<void(double)> taken);
    QSpinBox* whole(const QString& label, const QString& name, int value, int minimum, int maximum, std::function<void(int)> taken);
    QComboBox* choice(const QString& label, const QString& name, const std::vector<std::pair<QString, QVariant>>& choices, const QVariant& chosen,
                      std::function<void(const QVariant&)> taken);
    QCheckBox* check(const QString& label, const QString& name, bool value, std::function<void(bool)> taken);
    QLineEdit* text(const QString& label, const QString& name, const QString& value, std::function<void(const QString&)> taken);
    /// Several lines, over the whole width.
    QPlainTextEdit* longText(const QString& label, const QString& name, const QString& value, int lines, std::function<void(const QString&)> taken);
    /// Numbers separated by semicolons; what is no number is left out. Over the whole width.
    QLineEdit* list(const QString& label, const QString& name, const std::vector<double>& values, std::function<void(std::vector<double>)> taken);
    /// Anything else over the whole width, in its turn.
    void wide(QWidget* widget);
    void cell(QWidget* widget); ///< in one column
    /// Stops "5" of the wheel from changing a field that is only scrolled past.
    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void add(const QString& label, QWidget* field, const QString& name, bool wide = false);
    void put(QWidget* widget, bool wide, Qt::AlignmentFlag level = Qt::AlignTop);
    void arrange(int columns);

    struct Cell {
        QWidget* widget;
        bool wide;
        Qt::AlignmentFlag level;
    };
    const Theme& m_theme;
    QLocale m_locale;
    bool m_readOnly;
    QGridLayout* m_grid;
    std::vector<Cell> m_cells;
    int m_columns = 0;
};

/// "0.02; 0.05; 0.1" in the locale, and back.
QString listText(const std::vector<double>& values, const QLocale& locale);
std::vector<double> listOf(const QString& text, const QLocale& locale);

} // namespace chiron::desktop
