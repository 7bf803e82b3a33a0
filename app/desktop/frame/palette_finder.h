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

/// Finds for the palette what is not on the present screen: people, exercises, sessions and studies by name, on a worker and read
/// once for each opening; and the commands of the other screens, each of which leads to its screen with the focus on its button, so
/// that nothing is done to something that is not seen. GUI thread.
class PaletteFinder final : public QObject {
    Q_OBJECT
public:
    static constexpr int kMost = 6; ///< of one kind

    PaletteFinder(AppContext& context, QObject* parent);

    void serve(CommandPalette& palette); ///< until that closes

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
    QTimer m_pause; ///< between two letters nobody needs an answer
    QString m_typed;
    std::shared_ptr<const SearchIndex> m_index;
    std::shared_ptr<WorkToken> m_work;
    QStringList m_toCollect;
    std::vector<Elsewhere> m_elsewhere; ///< of this person, in this language
    bool m_collected = false;
};

} // namespace chiron::desktop
