// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/levels_table.h"

#include "desktop/studies/number_list.h"
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
} // namespace

LevelsTable::LevelsTable(const Theme& theme, const QLocale& locale, bool readOnly, const QString& name,
                         const std::vector<double>& percents, std::function<QString(double)> value,
                         QWidget* parent)
    : QWidget(parent), m_locale(locale), m_readOnly(readOnly), m_value(std::move(value)),
      m_table(new QTableWidget) {
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
    connect(m_table, &QTableWidget::cellChanged, this, [this](int row, int) { edited(row); });
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
        m_filling = false;
        m_table->setCurrentCell(m_table->rowCount() - 1, percentColumn);
        m_table->editItem(m_table->currentItem());
        taken();
    });
    add(tr("Remove the row"), "list-remove", ".remove", [this] {
        if (m_table->rowCount() > 1 && m_table->currentRow() >= 0)
            m_table->removeRow(m_table->currentRow());
        taken();
    });
    column->addWidget(bar);
}

void LevelsTable::fill(const std::vector<double>& percents) {
    m_filling = true;
    m_table->setRowCount(static_cast<int>(percents.size()));
    for (int row = 0; row < m_table->rowCount(); ++row)
        setRow(row, percents[static_cast<std::size_t>(row)]);
    m_filling = false;
}

QString LevelsTable::shown(double percent) const {
    constexpr int kDigits = 4;
    return m_locale.toString(percent, 'g', kDigits);
}

void LevelsTable::setRow(int row, double percent) {
    auto* number = new QTableWidgetItem(shown(percent));
    number->setData(Qt::UserRole, percent); // unrounded, because the shown value is rounded
    auto* value = new QTableWidgetItem(m_value(percent));
    number->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setFlags(Qt::ItemIsEnabled);
    if (m_readOnly)
        number->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    m_table->setItem(row, percentColumn, number);
    m_table->setItem(row, valueColumn, value);
}

void LevelsTable::showValues() {
    m_filling = true;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const NumberList read = readNumbers(m_table->item(row, percentColumn)->text(), m_locale);
        if (!read.values.empty())
            m_table->item(row, valueColumn)->setText(m_value(read.values.front()));
    }
    m_filling = false;
}

void LevelsTable::edited(int row) {
    if (m_filling)
        return;
    const NumberList read = readNumbers(m_table->item(row, percentColumn)->text(), m_locale);
    if (read.unread.isEmpty() && read.values.size() == 1) {
        m_filling = true;
        m_table->item(row, valueColumn)->setText(m_value(read.values.front()));
        m_filling = false;
    }
    taken();
}

/// Emits all rows, or the error of the first row that is not a number.
void LevelsTable::taken() {
    std::vector<double> percents;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QTableWidgetItem* item = m_table->item(row, percentColumn);
        const QString text = item->text();
        if (const double exact = item->data(Qt::UserRole).toDouble(); text == shown(exact)) {
            percents.push_back(exact);
            continue;
        }
        NumberList read = readNumbers(text, m_locale);
        if (read.unread.isEmpty() && read.values.size() != 1)
            read.unread = text;
        if (!read.unread.isEmpty()) {
            emit unread(unreadWords(read));
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
