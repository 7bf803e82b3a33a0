// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>
#include <QRect>
#include <memory>
#include <vector>

namespace chiron::desktop {

/// Lays items out one after the other, with as many per line as fit, for rows of controls that a large scale
/// or long text would push out of the window. Items in a line are vertically aligned. It has no margins of
/// its own.
/// Thread: GUI.
class FlowLayout final : public QLayout {
public:
    explicit FlowLayout(int spacing_px, QWidget* parent = nullptr);
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override;
    int count() const override { return static_cast<int>(m_items.size()); }
    QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return {}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return arrange({0, 0, width, 0}, false); }
    QSize minimumSize() const override;
    QSize sizeHint() const override { return minimumSize(); }
    void setGeometry(const QRect& area) override;

private:
    /// The height that the items need in the width of `area`. With `place` it also positions them.
    int arrange(const QRect& area, bool place) const;

    std::vector<std::unique_ptr<QLayoutItem>> m_items;
};

} // namespace chiron::desktop
