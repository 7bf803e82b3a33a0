// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/command_list.h"
#include "desktop/theme/theme.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QListWidget;

namespace chiron::desktop {

/// Ctrl+K: type a few letters, press Enter. Every command that can be given now, with its keys. The letters may be anywhere
/// in the words, in order; words that begin with them come first. GUI thread.
class CommandPalette final : public QDialog {
    Q_OBJECT
public:
    CommandPalette(const Theme& theme, std::vector<CommandGroup> groups, QWidget* parent);

    /// How well `typed` fits `text`: 0 not at all; larger is better. Pure; case and accents do not count.
    static int fit(const QString& typed, const QString& text);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void filter(const QString& typed);
    void runCurrent();

    std::vector<CommandGroup> m_groups;
    QLineEdit* m_field;
    QListWidget* m_list;
    QLabel* m_nothing;
};

} // namespace chiron::desktop
