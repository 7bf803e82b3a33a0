// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"
#include "desktop/home/comment_list.h"

#include <vector>

class QComboBox;
class QVBoxLayout;

namespace chiron::desktop {

class StatePanel;

/// Lists all comments that a person received or wrote, unread ones first, each with a link to its moment. A
/// comment shown here counts as read. The place is {which: received, written}; without `which` all are shown.
/// Thread: GUI.
class CommentsScreen final : public Screen {
    Q_OBJECT
public:
    CommentsScreen(AppContext& context, const Place& place);

    QString title() const override;
    QString help() const override;
    void enter() override;

private:
    void load();
    void show(std::vector<FoundComment> comments);
    void build();
    void fill();
    void addMore(); ///< shows the next ones
    QWidget* card(const FoundComment& comment, bool unread);
    QString headOf(const FoundComment& comment) const;
    bool isUnread(const FoundComment& comment) const;
    void open(const FoundComment& comment);
    bool leadsToItsMoment(const FoundComment& comment) const;

    StatePanel* m_panel = nullptr;
    QComboBox* m_which = nullptr;
    QVBoxLayout* m_lines = nullptr;
    QWidget* m_holder = nullptr;
    QWidget* m_more = nullptr;
    std::vector<FoundComment> m_comments;
    std::vector<const FoundComment*> m_chosen; ///< points into m_comments, in the order shown
    std::vector<bool> m_unread;                ///< per entry of m_comments, as of opening the screen
    std::size_t m_shown = 0;
};

} // namespace chiron::desktop
