// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/command_palette.h"

#include "desktop/frame/command_words.h"
#include "desktop/frame/key_names.h"
#include "desktop/frame/palette_search.h"
#include "desktop/widgets/kit.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <algorithm>

namespace chiron::desktop {

namespace {

enum Data { kGroup = Qt::UserRole, kCommand };
constexpr int kFirstFound = 1000; // indices of the found groups start here
constexpr int kGoodFit = 3;       // the letters are adjacent

/// How well a command matches, by its own text or by a synonym.
int fitOf(const QString& typed, const QString& command) {
    const int own = CommandPalette::fit(typed, command);
    return own < kGoodFit && !furtherWordThatFits(typed, command).isEmpty() ? kGoodFit : own;
}

} // namespace

CommandPalette::CommandPalette(const Theme& theme, std::vector<CommandGroup> groups, QWidget* parent)
    : QDialog(parent), m_theme(theme), m_groups(std::move(groups)) {
    setObjectName(QStringLiteral("palette"));
    setWindowTitle(tr("Find a command"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(theme.px(560), theme.px(420));
    auto* column = new QVBoxLayout(this);
    m_field = new QLineEdit;
    m_field->setObjectName(QStringLiteral("palette.field"));
    m_field->setAccessibleName(tr("Command"));
    m_field->setPlaceholderText(tr("Type what you want to do, or a name"));
    m_field->installEventFilter(this);
    m_list = new QListWidget;
    m_list->setObjectName(QStringLiteral("palette.list"));
    m_list->setAccessibleName(tr("Commands found"));
    m_nothing = kit::label(theme, tr("Nothing matches. Try fewer letters or another word."), TextStyle::body,
                           "muted");
    m_words = kit::label(theme, {}, TextStyle::small, "muted");
    m_words->setObjectName(QStringLiteral("palette.words"));
    m_words->hide();
    column->addWidget(m_field);
    column->addWidget(m_list, 1);
    column->addWidget(m_nothing);
    column->addWidget(m_words);
    connect(m_field, &QLineEdit::textChanged, this, &CommandPalette::type);
    connect(m_field, &QLineEdit::returnPressed, this, &CommandPalette::runCurrent);
    connect(m_list, &QListWidget::itemActivated, this, &CommandPalette::runCurrent);
    connect(m_list, &QListWidget::itemClicked, this, &CommandPalette::runCurrent);
    filter();
}

int CommandPalette::fit(const QString& typed, const QString& text) {
    const QString wanted = forSearch(typed.simplified());
    const QString in = forSearch(text);
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

const ScreenCommand& CommandPalette::commandOf(int group, int command) const {
    const std::vector<CommandGroup>& groups = group < kFirstFound ? m_groups : m_found;
    return groups[static_cast<std::size_t>(group % kFirstFound)].commands[static_cast<std::size_t>(command)];
}

void CommandPalette::type(const QString& text) {
    m_stepped = false;
    m_found.clear(); // it belongs to the previous text
    filter();
    emit typed(text);
}

void CommandPalette::showFound(std::vector<CommandGroup> found, const QString& words) {
    const QListWidgetItem* before = m_stepped ? m_list->currentItem() : nullptr;
    const QString chosen = before ? before->text() : QString();
    m_found = std::move(found);
    filter();
    if (!chosen.isEmpty()) // late results must not change the selected line
        if (const auto same = m_list->findItems(chosen, Qt::MatchExactly); !same.isEmpty())
            m_list->setCurrentItem(same.front());
    say(words);
}

void CommandPalette::say(const QString& words) {
    m_words->setText(words);
    m_words->setVisible(!words.isEmpty());
}

void CommandPalette::addHeading(const QString& title) {
    auto* item = new QListWidgetItem(title);
    item->setFlags(Qt::NoItemFlags);
    item->setFont(m_theme.font(TextStyle::small));
    item->setForeground(m_theme.color(Colour::muted));
    m_list->addItem(item);
}

void CommandPalette::addCommand(int group, int command) {
    const ScreenCommand& given = commandOf(group, command);
    const QString keys = shortcutInWords(given.keys);
    QString text = given.text;
    if (const QString word = group < kFirstFound && fit(m_field->text(), text) < kGoodFit
                                 ? furtherWordThatFits(m_field->text(), text)
                                 : QString();
        !word.isEmpty())
        text = tr("%1 – %2").arg(text, word); // shows which synonym matched
    auto* item = new QListWidgetItem(keys.isEmpty() ? text : tr("%1   (%2)").arg(text, keys));
    item->setData(kGroup, group);
    item->setData(kCommand, command);
    m_list->addItem(item);
}

void CommandPalette::filter() {
    struct Found {
        int fit;
        int group;
        int command;
    };
    std::vector<Found> found;
    for (int g = 0; g < static_cast<int>(m_groups.size()); ++g)
        for (int c = 0; c < static_cast<int>(m_groups[static_cast<std::size_t>(g)].commands.size()); ++c)
            if (const int fits = fitOf(m_field->text(), commandOf(g, c).text))
                found.push_back({fits, g, c});
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.fit > b.fit; });
    const auto loose =
        std::find_if(found.begin(), found.end(), [](const Found& f) { return f.fit < kGoodFit; });
    const auto add = [this](auto from, auto to) {
        for (; from != to; ++from)
            addCommand(from->group, from->command);
    };
    m_list->clear();
    if (m_found.empty()) {
        add(found.begin(), found.end());
    } else { // a found name comes before a command that only contains the letters
        if (loose != found.begin())
            addHeading(tr("Commands"));
        add(found.begin(), loose);
        for (int g = 0; g < static_cast<int>(m_found.size()); ++g) {
            addHeading(m_found[static_cast<std::size_t>(g)].title);
            for (int c = 0; c < static_cast<int>(m_found[static_cast<std::size_t>(g)].commands.size()); ++c)
                addCommand(kFirstFound + g, c);
        }
        if (loose != found.end())
            addHeading(tr("Further commands"));
        add(loose, found.end());
    }
    m_list->setCurrentRow(-1);
    step(1);
    m_list->setVisible(m_list->count() > 0);
    m_nothing->setVisible(m_list->count() == 0);
}

/// Moves to the next selectable line, skipping headings.
void CommandPalette::step(int by) {
    for (int row = m_list->currentRow() + by; row >= 0 && row < m_list->count(); row += by)
        if (m_list->item(row)->flags().testFlag(Qt::ItemIsSelectable)) {
            m_list->setCurrentRow(row);
            return;
        }
}

void CommandPalette::runCurrent() {
    const QListWidgetItem* item = m_list->currentItem();
    if (!item || !item->flags().testFlag(Qt::ItemIsSelectable))
        return;
    const auto act = commandOf(item->data(kGroup).toInt(), item->data(kCommand).toInt()).act;
    accept();
    if (act)
        act();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Down || key->key() == Qt::Key_Up) {
            m_stepped = true;
            step(key->key() == Qt::Key_Down ? 1 : -1);
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

} // namespace chiron::desktop
