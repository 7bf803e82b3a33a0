// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/command_list.h"
#include "desktop/theme/theme.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QListWidget;

namespace chiron::desktop {

/// The command palette (Ctrl+K): type a few letters and press Enter. It lists every available command with
/// its shortcut. The typed letters may lie anywhere in the text, in order; commands with a word that begins
/// with them come first. Results from elsewhere (people, sessions, commands of other screens) are listed
/// below in groups.
/// Thread: GUI.
class CommandPalette final : public QDialog {
    Q_OBJECT
public:
    CommandPalette(const Theme& theme, std::vector<CommandGroup> groups, QWidget* parent);

    /// How well `typed` matches `text`: 0 means no match, larger is better. Pure. Case and accents are
    /// ignored.
    static int fit(const QString& typed, const QString& text);

    /// Shows the results for the current text, and a remark about them (none if empty).
    void showFound(std::vector<CommandGroup> found, const QString& words);
    void say(const QString& words);

signals:
    void typed(const QString& text); ///< emitted after the matching commands are shown

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void type(const QString& typed);
    void filter();
    void addCommand(int group, int command);
    void addHeading(const QString& title);
    const ScreenCommand& commandOf(int group, int command) const;
    void step(int by);
    void runCurrent();

    const Theme& m_theme;
    std::vector<CommandGroup> m_groups;
    std::vector<CommandGroup> m_found; ///< for the current text
    QLineEdit* m_field;
    QListWidget* m_list;
    QLabel* m_nothing;
    QLabel* m_words;
    bool m_stepped = false; ///< the person moved the selection since the last letter
};

} // namespace chiron::desktop
