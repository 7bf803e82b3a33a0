// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/levels_table.h"

#include "desktop/studies/study_words.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QTableWidget>
#include <algorithm>

namespace chiron::desktop {

namespace {
enum Column { percentColumn, valueColumn, columns };
constexpr int kRowsShown = 6;
constexpr double kRow_px = 30;
constexpr double kWidth_px = 460;
constexpr double kNewRow_percent = 10.0;
constexpr int kFewestDigits = 4;
} // namespace

QStringList objectsOf(const psychophysics::StimulusDesign& stimulus, const std::vector<double>& percents,
                      const QLocale& locale) {
    constexpr double kPercent = 100.0;
    std::vector<double> objects;
    for (const double percent : percents)
        objects.push_back(stimulus.reference * (1.0 + percent / kPercent));
    return study_words::values(objects, stimulus.attribute, locale);
}

LevelsTable::LevelsTable(const Theme& theme, const QLocale& locale, bool readOnly, const QString& name,
                         const std::vector<double>& percents, Objects objects, QWidget* parent)
    : QWidget(parent), m_locale(locale), m_readOnly(readOnly), m_objects(std::move(objects)),
      m_table(new QTableWidget), m_digits(kFewestDigits) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(6));
    m_table->setObjectName(name + QStringLiteral(".table"));
    m_table->setColumnCount(columns);
    m_table->setFont(theme.font(TextStyle::body));
    m_table->setHorizontalHeaderLabels({tr("Difference (%)"), tr("Object")});
    m_table->setAccessibleName(tr("Differences from the reference in per cent"));
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->verticalHeader()->setDefaultSectionSize(theme.px(kRow_px));
    m_table->setTabKeyNavigation(false);    // Tab moves to the next control
    m_table->setCornerButtonEnabled(false); // there is no action for all cells at once
    m_table->setFixedHeight(theme.px(kRow_px) * (kRowsShown + 1) + theme.px(8));
    m_table->setMaximumWidth(theme.px(kWidth_px));
    m_table->installEventFilter(this);
    setFocusProxy(m_table);
    fill(percents);
    connect(m_table, &QTableWidget::cellChanged, this, [this] { edited(); });
    column->addWidget(m_table);
    if (readOnly)
        return;
    auto* bar = new QWidget;
    auto* row = new FlowLayout(theme.px(8), bar);
    const auto add = [&](const QString& text, const char* icon, const char* end, auto act) {
        auto* button = kit::button(theme, text, "quiet", QLatin1String(icon));
        button->setObjectName(name + QLatin1String(end));
        connect(button, &QPushButton::clicked, this, act);
        row->addWidget(button);
    };
    add(tr("Paste numbers"), "edit-paste", ".paste", [this] { pasteClipboard(); });
    add(tr("Add a row"), "list-add", ".add", [this] {
        m_filling = true;
        m_table->insertRow(m_table->rowCount());
        setRow(m_table->rowCount() - 1, kNewRow_percent);
        showValues();
        m_table->setCurrentCell(m_table->rowCount() - 1, percentColumn);
        m_table->editItem(m_table->currentItem());
        taken();
    });
    add(tr("Remove the row"), "list-remove", ".remove", [this] {
        if (m_table->rowCount() > 1 && m_table->currentRow() >= 0)
            m_table->removeRow(m_table->currentRow());
        showValues();
        taken();
    });
    column->addWidget(bar);
}

void LevelsTable::fill(const std::vector<double>& percents) {
    m_filling = true;
    m_digits = study_words::digitsThatDiffer(percents, kFewestDigits, [](double percent, int digits) {
        return QLocale::c().toString(percent, 'g', digits);
    });
    m_table->setRowCount(static_cast<int>(percents.size()));
    for (int row = 0; row < m_table->rowCount(); ++row)
        setRow(row, percents[static_cast<std::size_t>(row)]);
    showValues();
}

QString LevelsTable::shown(double percent) const {
    return m_locale.toString(percent, 'g', m_digits);
}

void LevelsTable::setRow(int row, double percent) {
    auto* number = new QTableWidgetItem(shown(percent));
    number->setData(Qt::UserRole, percent); // unrounded, because the shown value is rounded
    auto* value = new QTableWidgetItem;
    number->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setFlags(Qt::ItemIsEnabled);
    if (m_readOnly)
        number->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    m_table->setItem(row, percentColumn, number);
    m_table->setItem(row, valueColumn, value);
}

/// Rows that are not a number keep the object that they had.
void LevelsTable::showValues() {
    std::vector<int> rows;
    std::vector<double> percents;
    for (int row = 0; row < m_table->rowCount(); ++row)
        if (const NumberList read = numberOfRow(row); read.unread.isEmpty() && read.values.size() == 1) {
            rows.push_back(row);
            percents.push_back(read.values.front());
        }
    const QStringList objects = m_objects(percents);
    m_filling = true;
    for (std::size_t i = 0; i < rows.size(); ++i)
        m_table->item(rows[i], valueColumn)->setText(objects[static_cast<qsizetype>(i)]);
    m_filling = false;
}

/// The one number of a row, unrounded as long as nobody has changed its text. An empty row has none.
NumberList LevelsTable::numberOfRow(int row) const {
    const QTableWidgetItem* item = m_table->item(row, percentColumn);
    if (const double exact = item->data(Qt::UserRole).toDouble(); item->text() == shown(exact))
        return {{exact}, {}};
    NumberList read = readNumbers(item->text(), m_locale);
    if (read.unread.isEmpty() && read.values.size() > 1)
        read.unread = item->text();
    return read;
}

void LevelsTable::edited() {
    if (m_filling)
        return;
    showValues();
    taken();
}

/// Emits all rows, or the error of the first row that is not a number.
void LevelsTable::taken() {
    std::vector<double> percents;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const NumberList read = numberOfRow(row);
        if (!read.unread.isEmpty() || read.values.empty()) {
            emit unread(read.unread.isEmpty()
                            ? tr("A row is empty. Type a number into it, or remove the row.")
                            : unreadWords(read));
            return;
        }
        percents.push_back(read.values.front());
    }
    emit unread({});
    emit changed(percents);
}

void LevelsTable::paste(const QString& text) {
    const NumberList read = readNumbers(text, m_locale);
    if (!read.unread.isEmpty() || read.values.empty()) {
        emit unread(read.values.empty() && read.unread.isEmpty()
                        ? tr("There are no numbers to paste. Copy them first.")
                        : unreadWords(read));
        return;
    }
    fill(read.values);
    emit unread({});
    emit changed(read.values);
}

void LevelsTable::pasteClipboard() {
    paste(QGuiApplication::clipboard()->text());
}

bool LevelsTable::eventFilter(QObject* watched, QEvent* event) {
    if (!m_readOnly && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Paste)) {
        pasteClipboard();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace chiron::desktop
