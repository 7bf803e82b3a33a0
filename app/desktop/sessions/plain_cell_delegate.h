// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QStyledItemDelegate>

namespace chiron::desktop {

/// Paints cells with an icon and a text without the style sheet: a page of a table has two hundred of them,
/// and the style sheet takes ten times as long for each. The result looks like the style sheet's tables. A
/// cell may have a second, smaller line.
class PlainCellDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    static constexpr int kSecondLine = Qt::UserRole + 1; ///< role of the second line's text; may be empty

    explicit PlainCellDelegate(const Theme& theme, QObject* parent = nullptr)
        : QStyledItemDelegate(parent), m_theme(theme) {}
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;

private:
    const Theme& m_theme;
};

} // namespace chiron::desktop
