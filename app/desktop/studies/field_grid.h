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

/// The range and display format of a number field.
struct NumberRange {
    double minimum = -1e9;
    double maximum = 1e9;
    int decimals = 3;
    QString unit{};
    double step = 0.0; ///< 0: a tenth of what decimals show
    QString zero{};    ///< text for the smallest value ("no limit"); empty: its number
};

/// The explanation under a number field: its range and usual value, in the field's unit.
struct UsualNumber {
    double lowest = 0.0;
    double highest = 0.0;
    double usual = 0.0;
};

/// Labelled fields in as many columns as fit the width. Each field calls back when a person changes it, never
/// when it is filled by the program. Its explanation and its error stand below it. A read-only grid shows the
/// same fields, disabled.
/// Thread: GUI.
class FieldGrid : public QWidget {
    Q_OBJECT
public:
    FieldGrid(const Theme& theme, const QLocale& locale, bool readOnly, QWidget* parent = nullptr);

    QDoubleSpinBox* number(const QString& label, const QString& name, double value, const NumberRange& range,
                           std::function<void(double)> taken);
    QSpinBox* whole(const QString& label, const QString& name, int value, int minimum, int maximum,
                    std::function<void(int)> taken);
    QComboBox* choice(const QString& label, const QString& name,
                      const std::vector<std::pair<QString, QVariant>>& choices, const QVariant& chosen,
                      std::function<void(const QVariant&)> taken);
    QCheckBox* check(const QString& label, const QString& name, bool value, std::function<void(bool)> taken);
    QLineEdit* text(const QString& label, const QString& name, const QString& value,
                    std::function<void(const QString&)> taken, bool wholeWidth = false);
    /// A field of several lines over the whole width.
    QPlainTextEdit* longText(const QString& label, const QString& name, const QString& value, int lines,
                             std::function<void(const QString&)> taken);
    /// A list of numbers in one line over the whole width, as number_list.h reads it. Text that is not a
    /// number, or a number out of range, is an error of the field, and `taken` is not called.
    QLineEdit* list(const QString& label, const QString& name, const std::vector<double>& values,
                    std::function<void(std::vector<double>)> taken, const NumberRange& range = {});
    /// Adds any other widget over the whole width, as the next row.
    void wide(QWidget* widget);
    void cell(QWidget* widget); ///< in one column
    /// Adds a custom widget as a field over the whole width. It can have an explanation and an error like the
    /// others.
    void control(const QString& label, const QString& name, QWidget* field);

    /// Sets the explanation of a field in one sentence, shown below it and available to screen readers; for a
    /// number also its range.
    void explain(const QString& name, const QString& meaning);
    void explain(const QString& name, const QString& meaning, const UsualNumber& number);
    /// Shows errors by field name, below each field with an icon, and for screen readers. Names of other
    /// grids are ignored; fields without an entry have no error.
    void showFaults(const QMap<QString, QString>& faults);
    /// Sets the error for input that the field cannot read ("abc" for a number); empty clears it.
    void setUnread(const QString& name, const QString& words);
    /// Sets the error for a number that does not fit another field, so that neither was taken; empty clears
    /// it.
    void setConflict(const QString& name, const QString& words);
    /// Hides a field that does not apply now; ignores unknown names.
    void setShown(const QString& name, bool shown);
    bool hasField(const QString& name) const { return m_fields.contains(name); }
    QWidget* field(const QString& name) const;
    /// Name of a field whose input was not taken, with the error shown below it; empty if there is none.
    QString firstUnread() const;
    QString faultOf(const QString& name) const; ///< the error shown below it; empty if there is none

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
    QString limit(double number) const;
    void forgetWhenTaken(QAbstractSpinBox* field, const QString& name);

    /// A field with the texts below it.
    struct Field {
        QWidget* widget = nullptr;
        QBoxLayout* column = nullptr;
        QString meaning, unit, unread, conflict, given;
        QWidget* fault = nullptr; ///< null if there is no error
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
    QString m_refused; ///< field whose input was just refused, until its editingFinished signal
};

} // namespace chiron::desktop
