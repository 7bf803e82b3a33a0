// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QHash>
#include <QLocale>
#include <QMap>
#include <QString>
#include <QVariant>
#include <QWidget>
#include <functional>
#include <utility>
#include <vector>

class QAbstractSpinBox;
class QBoxLayout;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
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
    QString zero{};    ///< what the smallest value is called ("no limit"); empty: by its number
};

/// What is said under a number's field: what it may be and what it usually is, in the field's unit.
struct UsualNumber {
    double lowest = 0.0;
    double highest = 0.0;
    double usual = 0.0;
};

/// Fields under their labels in as many columns as the width has room for. Each calls back when it is changed by a person, never when it
/// is filled. Under a field stands what it means, and what is wrong with it. Read-only grids show the same fields, which cannot be changed.
/// GUI thread.
class FieldGrid : public QWidget {
    Q_OBJECT
public:
    FieldGrid(const Theme& theme, const QLocale& locale, bool readOnly, QWidget* parent = nullptr);

    QDoubleSpinBox* number(const QString& label, const QString& name, double value, const NumberRange& range, std::function<void(double)> taken);
    QSpinBox* whole(const QString& label, const QString& name, int value, int minimum, int maximum, std::function<void(int)> taken);
    QComboBox* choice(const QString& label, const QString& name, const std::vector<std::pair<QString, QVariant>>& choices, const QVariant& chosen,
                      std::function<void(const QVariant&)> taken);
    QCheckBox* check(const QString& label, const QString& name, bool value, std::function<void(bool)> taken);
    QLineEdit* text(const QString& label, const QString& name, const QString& value, std::function<void(const QString&)> taken, bool wholeWidth = false);
    /// Several lines, over the whole width.
    QPlainTextEdit* longText(const QString& label, const QString& name, const QString& value, int lines, std::function<void(const QString&)> taken);
    /// Numbers in a line, as number_list.h reads them; what is no number is a fault of the field, and nothing is taken. Over the whole width.
    QLineEdit* list(const QString& label, const QString& name, const std::vector<double>& values, std::function<void(std::vector<double>)> taken);
    /// Anything else over the whole width, in its turn.
    void wide(QWidget* widget);
    void cell(QWidget* widget); ///< in one column
    /// A widget of its own as a field, over the whole width: it can be explained and be wrong as the others.
    void control(const QString& label, const QString& name, QWidget* field);

    /// One sentence of what the field of this name means, under it and for screen readers; of a number with what it may be.
    void explain(const QString& name, const QString& meaning);
    void explain(const QString& name, const QString& meaning, const UsualNumber& number);
    /// What is wrong with the fields, by name: said under each with a sign, and for screen readers. Names of other grids are passed over; fields
    /// that are not named are right.
    void showFaults(const QMap<QString, QString>& faults);
    /// What the field itself cannot take ("abc" for a number); empty: nothing.
    void setUnread(const QString& name, const QString& words);
    void setShown(const QString& name, bool shown); ///< where a field does not apply now; nothing where there is none of this name
    bool hasField(const QString& name) const { return m_fields.contains(name); }
    QWidget* field(const QString& name) const;
    /// Name of a field with something in it that it cannot take, told under it; empty: none.
    QString firstUnread() const;
    QString faultOf(const QString& name) const; ///< what is said under it; empty: nothing

    /// Stops "5" of the wheel from changing a field that is only scrolled past.
    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    const Theme& gridTheme() const { return m_theme; }
    const QLocale& gridLocale() const { return m_locale; }
    bool isReadOnly() const { return m_readOnly; }
    void resizeEvent(QResizeEvent* event) override;

private:
    void add(const QString& label, QWidget* field, const QString& name, bool wide = false);
    void put(QWidget* widget, bool wide, Qt::AlignmentFlag level = Qt::AlignTop);
    void arrange(int columns);
    void showFault(const QString& name);
    void refuse(const QString& name, const QString& words);
    void forgetWhenTaken(QAbstractSpinBox* field, const QString& name);

    /// A field with what is said under it.
    struct Field {
        QWidget* widget = nullptr;
        QBoxLayout* column = nullptr;
        QString meaning, unit, unread, given;
        QWidget* fault = nullptr; ///< null where nothing is wrong
    };
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
    QHash<QString, Field> m_fields;
    int m_columns = 0;
    QString m_refused; ///< field whose text was refused just now, until it says that its editing is over
};

} // namespace chiron::desktop
