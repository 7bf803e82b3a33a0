// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>

class QLabel;
class QScrollArea;
class QVBoxLayout;

namespace chiron::desktop {

class InfoView;

/// The column beside the scene. Where the window is too low for it, the measurements first give up what they
/// show twice (InfoView::giveUp), and then it scrolls. The pointer belongs to the scene while somebody works,
/// so it scrolls by key; a line below it says which.
/// Thread: GUI.
class SidePanel final : public QWidget {
    Q_OBJECT
public:
    explicit SidePanel(const Theme& theme, QWidget* parent = nullptr);

    /// Where the parts of the column are put. Their owner is the panel.
    QVBoxLayout& column() { return *m_column; }
    /// Adds the measurements to the column; the space that is left belongs to them.
    void addInfo(InfoView* info);
    /// Call it when a part has changed its height; a change of size does so by itself.
    void fit();
    void readOn(bool down);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    int needed_px() const; ///< the height of the whole column

    void keepHeight();

    QScrollArea* m_page;
    QVBoxLayout* m_column = nullptr;
    InfoView* m_info = nullptr;
    int m_below_px = 0; ///< kept for the hint below the page
    bool m_fitting = false;
};

} // namespace chiron::desktop
