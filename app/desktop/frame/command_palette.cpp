// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/command_palette.h"

#include "desktop/widgets/kit.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <algorithm>

namespace chiron::desktop {

namespace {

/// Lower case without accents: "ubersicht" finds "Übersicht", "αρχικη" finds "Αρχική".
QString plain(const QString& text) {
    QString out;
    for (const QChar c : text.normalized(QString::NormalizationForm_D).toCaseFolded())
        if (!c.isMark())
            out += c;
    return out;
}

} // namespace

CommandPalette::CommandPalette(const Theme& theme, std::vector<CommandGroup> groups, QWidget* parent)
    : QDialog(parent), m_groups(std::move(groups)) {
    setObjectName(QStringLiteral("palette"));
    setWindowTitle(tr("Find a command"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(theme.px(560), theme.px(420));
    auto* column = new QVBoxLayout(this);
    m_field = new QLineEdit;
    m_field->setObjectName(QStringLiteral("palette.field"));
    m_field->setAccessibleName(tr("Command"));
    m_field->setPlaceholderText(tr("Type what you want to do"));
    m_field->installEventFilter(this);
    m_list = new QListWidget;
    m_list->setObjectName(QStringLiteral("palette.list"));
    m_list->setAccessibleName(tr("Commands found"));
    m_nothing = kit::label(theme, tr("No matching command. Try fewer letters or another word."), TextStyle::body, "muted");
    column->addWidget(m_field);
    column->addWidget(m_list, 1);
    column->addWidget(m_nothing);
    connect(m_field, &QLineEdit::textChanged, this, &CommandPalette::filter);
    connect(m_field, &QLineEdit::returnPressed, this, &CommandPalette::runCurrent);
    connect(m_list, &QListWidget::itemActivated, this, &CommandPalette::runCurrent);
    connect(m_list, &QListWidget::itemClicked, this, &CommandPalette::runCurrent);
    filter({});
}

int CommandPalette::fit(const QString& typed, const QString& text) {
    const QString wanted = plain(typed.simplified());
    const QString in = plain(text);
    if (wanted.isEmpty())
        return 1;
    const qsizetype at = in.indexOf(wanted);
    if (at >= 0)
        return at == 0 || in.at(at - 1).isSpace() ? 4 : 3;
    qsizetype from = 0;
    for (const QChar c : wanted) {
        from = in.indexOf(c, from) + 1;
        if (from == 0)
            return 0;
    }
    return 2;
}

void CommandPalette::filter(const QString& typed) {
    struct Found {
        int fit;
        int group;
        int command;
    };
    std::vector<Found> found;
    for (int g = 0; g < static_cast<int>(m_groups.size()); ++g)
        for (int c = 0; c < static_cast<int>(m_groups[static_cast<std::size_t>(g)].commands.size()); ++c)
            if (const int fits = fit(typed, m_groups[static_cast<std::size_t>(g)].commands[static_cast<std::size_t>(c)].text))
                found.push_back({fits, g, c});
    std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.fit > b.fit; });
    m_list->clear();
    for (const Found& f : found) {
        const ScreenCommand& command = m_groups[static_cast<std::size_t>(f.group)].commands[static_cast<std::size_t>(f.command)];
        const QString keys = command.keys.toString(QKeySequence::NativeText);
        auto* item = new QListWidgetItem(keys.isEmpty() ? command.text : tr("%1   (%2)").arg(command.text, keys));
        item->setData(Qt::UserRole, f.group);
        item->setData(Qt::UserRole + 1, f.command);
        m_list->addItem(item);
    }
    m_list->setCurrentRow(0);
    m_list->setVisible(!found.empty());
    m_nothing->setVisible(found.empty());
}

void CommandPalette::runCurrent() {
    const QListWidgetItem* item = m_list->currentItem();
    if (!item)
        return;
    const auto group = static_cast<std::size_t>(item->data(Qt::UserRole).toInt());
    const auto command = static_cast<std::size_t>(item->data(Qt::UserRole + 1).toInt());
    const auto act = m_groups[group].commands[command].act;
    accept();
    if (act)
        act();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Down || key->key() == Qt::Key_Up) {
            const int step = key->key() == Qt::Key_Down ? 1 : -1;
            m_list->setCurrentRow(qBound(0, m_list->currentRow() + step, m_list->count() - 1));
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

} // namespace chiron::desktop
