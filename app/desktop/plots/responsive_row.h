// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBoxLayout>
#include <QWidget>

namespace chiron::desktop {

/// Arranges widgets side by side, or one below the other if the width is less than `turnsAt_px`, for small
/// windows, large text and long words.
/// Thread: GUI.
class ResponsiveRow : public QWidget {
    Q_OBJECT
public:
    ResponsiveRow(int turnsAt_px, int spacing_px, QWidget* parent = nullptr);
    void add(QWidget* part, int stretch = 1) { m_layout->addWidget(part, stretch); }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QBoxLayout* m_layout;
    int m_turnsAt_px;
};

} // namespace chiron::desktop
