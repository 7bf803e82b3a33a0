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
/// in the words, in order; words that begin with them come first. What somebody else finds for the letters (people, sessions,
/// commands of other screens) is listed below, by groups. GUI thread.
class CommandPalette final : public QDialog {
    Q_OBJECT
public:
    CommandPalette(const Theme& theme, std::vector<CommandGroup> groups, QWidget* parent);

    /// How well `typed` fits `text`: 0 not at all; larger is better. Pure; case and accents do not count.
    static int fit(const QString& typed, const QString& text);

    /// What was found for the letters that are typed now, and what is to be said of it (empty: nothing).
    void showFound(std::vector<CommandGroup> found, const QString& words);
    void say(const QString& words);

signals:
    void typed(const QString& text); ///< after the commands that fit it are shown

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
    std::vector<CommandGroup> m_found; ///< for what is typed now
    QLineEdit* m_field;
    QListWidget* m_list;
    QLabel* m_nothing;
    QLabel* m_words;
    bool m_stepped = false; ///< the person chose a line since the last letter
};

} // namespace chiron::desktop
