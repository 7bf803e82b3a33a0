// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QStyledItemDelegate>

namespace chiron::desktop {

/// Paints a person's roles as chips, each labelled with its role.
/// Thread: GUI.
class RoleChips final : public QStyledItemDelegate {
public:
    RoleChips(const Theme& theme, QObject* parent) : QStyledItemDelegate(parent), m_theme(theme) {}

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    int chipWidth(const QString& text) const;

    const Theme& m_theme;
};

} // namespace chiron::desktop
