// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/field_grid.h"

#include "desktop/accounts/form.h"
#include "desktop/studies/number_list.h"
#include "desktop/studies/quantity_text.h"
#include "desktop/widgets/kit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPointer>
#include <QResizeEvent>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {
constexpr double kCell_px = 250;
constexpr double kLine_px = 22;

/// The typed text without the unit that the field appends itself.
QString typedIn(const QString& text, const QString& suffix) {
    return (!suffix.isEmpty() && text.endsWith(suffix) ? text.chopped(suffix.size()) : text).trimmed();
}

/// A spin box that never discards input silently. Invalid input stays in the field during typing and is
/// reported when the field is left. Then the previous value returns, because a readable beginning ("0.3" of
/// "0.3 kg") was not meant either.
template <class SpinBox> class TellingSpinBox : public SpinBox {
public:
    std::function<void(const QString& typed)> refused;

    void fixup(QString& input) const override {
        if (refused)
            refused(typedIn(input, this->suffix()));
        input = before();
    }
    void keep() { m_before = this->value(); } ///< sets the value that a refusal returns to
    QString before() const {
        const bool special = m_before == this->minimum() && !this->specialValueText().isEmpty();
        return special ? this->specialValueText() : this->textFromValue(m_before) + this->suffix();
    }

protected:
    void focusInEvent(QFocusEvent* event) override {
        keep();
        SpinBox::focusInEvent(event);
    }

private:
    decltype(std::declval<SpinBox>().value()) m_before{};
};

/// Shows a number as people write it: 300 and 0.75, not 300.0000 and 0.750. Accepts any unit of the same
/// dimension.
class PlainSpinBox final : public TellingSpinBox<QDoubleSpinBox> {
public:
    ReadQuantity read(const QString& text) const {
        const QString suffix = this->suffix();
        return readQuantity(typedIn(text, suffix), suffix.trimmed(), locale());
    }
    bool isSpecial(const QString& text) const { // the unit stays behind what is typed
        return !specialValueText().isEmpty() && typedIn(text, suffix()) == specialValueText();
    }
    bool inRange(double value) const { return value >= minimum() && value <= maximum(); }
    bool keeps(double value) const { // otherwise rounding would turn a small number into zero
        constexpr double kRounding = 0.01;
        const double steps = std::pow(10.0, decimals());
        return std::abs(std::round(value * steps) / steps - value) <= kRounding * std::abs(value);
    }
    QValidator::State validate(QString& input, int&) const override {
        if (isSpecial(input))
            return QValidator::Acceptable;
        const ReadQuantity found = read(input);
        return found.fault == ReadQuantity::Fault::none && inRange(found.value) && keeps(found.value)
                   ? QValidator::Acceptable
                   : QValidator::Intermediate;
    }
    double valueFromText(const QString& text) const override {
        return isSpecial(text) ? minimum() : read(text).value;
    }
    QString textFromValue(double value) const override {
        QString text = QDoubleSpinBox::textFromValue(value);
        const QString point = locale().decimalPoint();
        if (!text.contains(point))
            return text;
        while (text.endsWith(locale().zeroDigit()))
            text.chop(1);
        return text.endsWith(point) ? text.chopped(point.size()) : text;
    }
};

/// The same for whole numbers.
class WholeSpinBox final : public TellingSpinBox<QSpinBox> {
public:
    QValidator::State validate(QString& input, int&) const override {
        const ReadQuantity found = readQuantity(input, {}, locale());
        const bool whole = found.fault == ReadQuantity::Fault::none && found.value == std::round(found.value);
        return whole && found.value >= minimum() && found.value <= maximum() ? QValidator::Acceptable
                                                                             : QValidator::Intermediate;
    }
    int valueFromText(const QString& text) const override {
        return static_cast<int>(readQuantity(text, {}, locale()).value);
    }
};
} // namespace

FieldGrid::FieldGrid(const Theme& theme, const QLocale& locale, bool readOnly, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_locale(locale), m_readOnly(readOnly), m_grid(new QGridLayout(this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(theme.px(16));
    m_grid->setVerticalSpacing(theme.px(12));
}

void FieldGrid::add(const QString& label, QWidget* field, const QString& name, bool wide) {
    field->setObjectName(name);
    field->setAccessibleName(label);
    field->setFont(m_theme.font(TextStyle::body));
    auto* cell = new QWidget;
    auto* column = new QVBoxLayout(cell);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(m_theme.px(4));
    if (!qobject_cast<QCheckBox*>(field)) {
        auto* words = kit::label(m_theme, label, TextStyle::label);
        words->setBuddy(field);
        column->addWidget(words);
    } else {
        column->addSpacing(m_theme.px(kLine_px)); // aligns it with fields that have a label above them
    }
    column->addWidget(field);
    Field& kept = m_fields[name];
    kept = {};
    kept.widget = field;
    kept.column = column;
    put(cell, wide);
}

void FieldGrid::control(const QString& label, const QString& name, QWidget* field) {
    add(label, field, name, true);
}

QWidget* FieldGrid::field(const QString& name) const {
    return m_fields.value(name).widget;
}

void FieldGrid::setShown(const QString& name, bool shown) {
    if (QWidget* found = field(name))
        found->parentWidget()->setVisible(shown);
}

QString FieldGrid::faultOf(const QString& name) const {
    const Field found = m_fields.value(name);
    for (const QString& words : {found.unread, found.conflict})
        if (!words.isEmpty())
            return words;
    return found.given;
}

void FieldGrid::explain(const QString& name, const QString& meaning) {
    Field& found = m_fields[name];
    if (!found.widget)
        return;
    found.meaning = meaning;
    found.widget->setAccessibleDescription(meaning);
    auto* words = kit::label(m_theme, meaning, TextStyle::small, "muted");
    words->setObjectName(name + QStringLiteral(".meaning"));
    found.column->insertWidget(found.column->indexOf(found.widget) + 1, words);
}

void FieldGrid::explain(const QString& name, const QString& meaning, const UsualNumber& number) {
    const QString unit = m_fields.value(name).unit;
    const QString allowed =
        tr("%1 to %2, usually %3.")
            .arg(limit(number.lowest),
                 limit(number.highest) + (unit.isEmpty() ? QString() : QLatin1Char(' ') + unit),
                 limit(number.usual));
    explain(name, meaning + QLatin1Char(' ') + allowed);
}

void FieldGrid::setUnread(const QString& name, const QString& words) {
    if (!m_fields.contains(name) || m_fields[name].unread == words)
        return;
    m_fields[name].unread = words;
    showFault(name);
}

void FieldGrid::setConflict(const QString& name, const QString& words) {
    if (!m_fields.contains(name) || m_fields[name].conflict == words)
        return;
    m_fields[name].conflict = words;
    showFault(name);
}

/// A limit as people write it: never with an exponent.
QString FieldGrid::limit(double number) const {
    constexpr double kLong = 1e6;
    return std::abs(number) < kLong ? m_locale.toString(number, 'g', 6) : m_locale.toString(number, 'f', 0);
}

void FieldGrid::showFaults(const QMap<QString, QString>& faults) {
    for (auto each = m_fields.begin(); each != m_fields.end(); ++each) {
        const QString words = faults.value(each.key());
        if (each->given == words)
            continue;
        each->given = words;
        showFault(each.key());
    }
}

/// The error is shown by an icon and text below the field, so that colour never stands alone.
void FieldGrid::showFault(const QString& name) {
    Field& found = m_fields[name];
    const QString words = faultOf(name);
    delete found.fault;
    found.fault = nullptr;
    form::setKind(found.widget, words.isEmpty() ? "" : "bad");
    found.widget->setAccessibleDescription(words.isEmpty() ? found.meaning
                                                           : words + QLatin1Char(' ') + found.meaning);
    if (words.isEmpty())
        return;
    found.fault = new QWidget;
    found.fault->setObjectName(name + QStringLiteral(".fault"));
    auto* row = new QHBoxLayout(found.fault);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(m_theme.px(6));
    auto* sign = new QLabel;
    const int size = m_theme.px(16);
    sign->setPixmap(m_theme.icon(QStringLiteral("dialog-error"), Colour::bad).pixmap(size, size));
    row->addWidget(sign, 0, Qt::AlignTop);
    row->addWidget(kit::label(m_theme, words, TextStyle::small, "bad"), 1);
    found.column->insertWidget(found.column->indexOf(found.widget) + 1, found.fault);
}

void FieldGrid::wide(QWidget* widget) {
    put(widget, true);
}

void FieldGrid::cell(QWidget* widget) {
    put(widget, false);
}

void FieldGrid::put(QWidget* widget, bool wide, Qt::AlignmentFlag level) {
    m_cells.push_back({widget, wide, level});
    m_columns = 0;
    arrange(std::max(1, width() / m_theme.px(kCell_px)));
}

QDoubleSpinBox* FieldGrid::number(const QString& label, const QString& name, double value,
                                  const NumberRange& range, std::function<void(double)> taken) {
    auto* field = new PlainSpinBox;
    field->setLocale(m_locale);
    field->setDecimals(range.decimals);
    field->setRange(range.minimum, range.maximum);
    field->setSingleStep(range.step > 0.0 ? range.step : std::pow(10.0, -std::min(range.decimals, 2)));
    if (!range.unit.isEmpty())
        field->setSuffix(QLatin1Char(' ') + range.unit);
    field->setSpecialValueText(range.zero);
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setValue(value);
    field->setReadOnly(m_readOnly);
    field->setFocusPolicy(Qt::StrongFocus);
    connect(field, &QDoubleSpinBox::valueChanged, this,
            [taken = std::move(taken)](double now) { taken(now); });
    add(label, field, name);
    m_fields[name].unit = range.unit;
    field->refused = [this, grid = QPointer<FieldGrid>(this), field, name,
                      unit = range.unit](const QString& typed) {
        if (!grid)
            return; // the grid is being destroyed together with the focused field
        const ReadQuantity found = readQuantity(typed, unit, m_locale);
        const QString still = field->before();
        switch (found.fault) {
        case ReadQuantity::Fault::empty:
            refuse(name, tr("A number is needed here. The value is still %1.").arg(still));
            return;
        case ReadQuantity::Fault::noNumber:
        case ReadQuantity::Fault::otherUnit:
            refuse(name,
                   unit.isEmpty()
                       ? tr("“%1” was not accepted: enter a number without a unit. The value is still %2.")
                             .arg(typed, still)
                       : tr("“%1” was not accepted: enter a value in %2. The value is still %3.")
                             .arg(typed, unit, still));
            return;
        case ReadQuantity::Fault::none:
            break;
        }
        refuse(name, field->inRange(found.value)
                         ? tr("“%1” was not accepted: it has more decimals than this field keeps. The value "
                              "is still %2.")
                               .arg(typed, still)
                         : tr("“%1” was not accepted: choose a value from %2 to %3. The value is still %4.")
                               .arg(typed, limit(field->minimum()), limit(field->maximum()) + field->suffix(),
                                    still));
    };
    forgetWhenTaken(field, name);
    field->keep();
    connect(field, &QAbstractSpinBox::editingFinished, field, [field] { field->keep(); });
    return field;
}

void FieldGrid::refuse(const QString& name, const QString& words) {
    m_refused = name; // marks this refusal until editingFinished
    setUnread(name, words);
}

/// A refusal remains visible until the field is left with valid input.
void FieldGrid::forgetWhenTaken(QAbstractSpinBox* field, const QString& name) {
    connect(field, &QAbstractSpinBox::editingFinished, this, [this, grid = QPointer<FieldGrid>(this), name] {
        if (!grid)
            return;
        if (m_refused != name)
            setUnread(name, {});
        m_refused.clear();
    });
}

QString FieldGrid::firstUnread() const {
    for (auto each = m_fields.begin(); each != m_fields.end(); ++each)
        if (!each->unread.isEmpty() || !each->conflict.isEmpty())
            return each.key();
    return {};
}

QSpinBox* FieldGrid::whole(const QString& label, const QString& name, int value, int minimum, int maximum,
                           std::function<void(int)> taken) {
    auto* field = new WholeSpinBox;
    field->setLocale(m_locale);
    field->setRange(minimum, maximum);
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setValue(value);
    field->setReadOnly(m_readOnly);
    field->setFocusPolicy(Qt::StrongFocus);
    connect(field, &QSpinBox::valueChanged, this, [taken = std::move(taken)](int now) { taken(now); });
    add(label, field, name);
    field->refused = [this, grid = QPointer<FieldGrid>(this), field, name](const QString& typed) {
        if (!grid)
            return;
        const QString still = field->before();
        refuse(name,
               typed.isEmpty()
                   ? tr("A number is needed here. The value is still %1.").arg(still)
                   : tr("“%1” was not accepted: enter a whole number from %2 to %3. The value is still %4.")
                         .arg(typed, m_locale.toString(field->minimum()), m_locale.toString(field->maximum()),
                              still));
    };
    forgetWhenTaken(field, name);
    field->keep();
    connect(field, &QAbstractSpinBox::editingFinished, field, [field] { field->keep(); });
    return field;
}

QComboBox* FieldGrid::choice(const QString& label, const QString& name,
                             const std::vector<std::pair<QString, QVariant>>& choices, const QVariant& chosen,
                             std::function<void(const QVariant&)> taken) {
    auto* field = new QComboBox;
    field->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    for (const auto& [words, value] : choices)
        field->addItem(words, value);
    field->setCurrentIndex(std::max(0, field->findData(chosen)));
    field->setEnabled(!m_readOnly);
    field->setFocusPolicy(Qt::StrongFocus);
    connect(field, &QComboBox::activated, this,
            [field, taken = std::move(taken)] { taken(field->currentData()); });
    add(label, field, name);
    return field;
}

QCheckBox* FieldGrid::check(const QString& label, const QString& name, bool value,
                            std::function<void(bool)> taken) {
    auto* field = new QCheckBox(label);
    field->setChecked(value);
    field->setEnabled(!m_readOnly);
    connect(field, &QCheckBox::toggled, this, [taken = std::move(taken)](bool now) { taken(now); });
    add(label, field, name);
    return field;
}

QLineEdit* FieldGrid::text(const QString& label, const QString& name, const QString& value,
                           std::function<void(const QString&)> taken, bool wholeWidth) {
    auto* field = new QLineEdit(value);
    field->setReadOnly(m_readOnly);
    connect(field, &QLineEdit::textEdited, this,
            [taken = std::move(taken)](const QString& now) { taken(now); });
    field->setCursorPosition(0);
    add(label, field, name, wholeWidth);
    return field;
}

QPlainTextEdit* FieldGrid::longText(const QString& label, const QString& name, const QString& value,
                                    int lines, std::function<void(const QString&)> taken) {
    auto* field = new QPlainTextEdit(value);
    field->setReadOnly(m_readOnly);
    field->setTabChangesFocus(true);
    field->setFixedHeight(m_theme.px(kLine_px) * lines + m_theme.px(20));
    connect(field, &QPlainTextEdit::textChanged, this,
            [field, taken = std::move(taken)] { taken(field->toPlainText()); });
    add(label, field, name, true);
    return field;
}

QLineEdit* FieldGrid::list(const QString& label, const QString& name, const std::vector<double>& values,
                           std::function<void(std::vector<double>)> taken, const NumberRange& range) {
    auto* field = new QLineEdit(listText(values, m_locale));
    field->setReadOnly(m_readOnly);
    field->setCursorPosition(0);
    const QString most =
        range.unit.isEmpty() ? limit(range.maximum) : limit(range.maximum) + QLatin1Char(' ') + range.unit;
    connect(field, &QLineEdit::textEdited, this,
            [this, name, range, most, taken = std::move(taken)](const QString& now) {
                const NumberList read = readNumbers(now, m_locale);
                const auto outside =
                    std::find_if(read.values.begin(), read.values.end(), [&range](double each) {
                        return each < range.minimum || each > range.maximum;
                    });
                const QString words =
                    read.unread.isEmpty() && outside != read.values.end()
                        ? tr("“%1” was not accepted: each number has to be from %2 to %3.")
                              .arg(m_locale.toString(*outside, 'g', 6), limit(range.minimum), most)
                        : unreadWords(read);
                setUnread(name, words);
                if (words.isEmpty())
                    taken(read.values);
            });
    add(label, field, name, true);
    return field;
}

void FieldGrid::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange(std::max(1, event->size().width() / m_theme.px(kCell_px)));
}

void FieldGrid::arrange(int columns) {
    if (columns == m_columns)
        return;
    m_columns = columns;
    for (const Cell& cell : m_cells)
        m_grid->removeWidget(cell.widget);
    int row = 0;
    int column = 0;
    for (const Cell& cell : m_cells) {
        if (column > 0 && (cell.wide || column >= columns)) {
            ++row;
            column = 0;
        }
        // The alignment also keeps a cell from claiming extra height; rows and cards would otherwise share
        // the free height of a tall page.
        m_grid->addWidget(cell.widget, row, column, 1, cell.wide ? columns : 1, cell.level);
        column = cell.wide ? columns : column + 1;
    }
    for (int i = 0; i < std::max(columns, m_grid->columnCount()); ++i)
        m_grid->setColumnStretch(i, i < columns ? 1 : 0);
}

} // namespace chiron::desktop
