// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/command_list.h"
#include "desktop/frame/palette_search.h"

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <memory>

namespace chiron::desktop {

class AppContext;
class CommandPalette;
class WorkToken;

/// Finds for the command palette what is not on the current screen. People, exercises, sessions and studies
/// are found by name; a worker reads them once per opening of the palette. Commands of other screens lead to
/// their screen with the focus on their button, so that nothing happens to something that is not visible.
/// Thread: GUI.
class PaletteFinder final : public QObject {
    Q_OBJECT
public:
    static constexpr int kMost = 6; ///< results shown per kind

    PaletteFinder(AppContext& context, QObject* parent);

    void serve(CommandPalette& palette); ///< until the palette closes

private:
    void forget();
    void look(const QString& typed);
    void find();
    void show(const std::shared_ptr<const SearchIndex>& index, const QString& typed);
    void collectNext();
    std::vector<ScreenCommand> commandsElsewhere(const QString& typed) const;

    struct Elsewhere {
        QString screen;
        QString title;
        QStringList commands;
    };

    AppContext& m_context;
    QPointer<CommandPalette> m_palette;
    QTimer m_pause; ///< delays the search until typing pauses
    QString m_typed;
    std::shared_ptr<const SearchIndex> m_index;
    std::shared_ptr<WorkToken> m_work;
    QStringList m_toCollect;
    std::vector<Elsewhere> m_elsewhere; ///< for the current person and language
    bool m_collected = false;
};

} // namespace chiron::desktop
