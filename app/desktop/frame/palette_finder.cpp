// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/palette_finder.h"

#include "desktop/frame/app_context.h"
#include "desktop/frame/command_palette.h"
#include "desktop/frame/screen.h"
#include "desktop/screen_catalogue.h"

#include <QApplication>
#include <QPushButton>

namespace chiron::desktop {

namespace {

constexpr int kPause_ms = 120;
constexpr int kShortest = 2; // a single letter matches nearly everything

QString titleOfKind(ThingKind kind) {
    switch (kind) {
    case ThingKind::person:
        return PaletteFinder::tr("People");
    case ThingKind::exercise:
        return PaletteFinder::tr("Exercises");
    case ThingKind::session:
        return PaletteFinder::tr("Sessions");
    case ThingKind::study:
        return PaletteFinder::tr("Studies");
    case ThingKind::count:
        break;
    }
    return {};
}

/// Focuses the button with this text once it is enabled, because the screen may still be loading.
class FocusWhenReady final : public QObject {
public:
    FocusWhenReady(QWidget* screen, QString text)
        : QObject(screen), m_screen(screen), m_text(std::move(text)) {
        constexpr int kLook_ms = 50;
        connect(&m_timer, &QTimer::timeout, this, [this] { look(); });
        m_timer.start(kLook_ms);
    }

private:
    void look() {
        constexpr int kMostLooks = 60; // 3 s
        for (auto* button : m_screen->findChildren<QPushButton*>())
            if (button->text() == m_text && button->isVisible() && button->isEnabled()) {
                button->setFocus(Qt::ShortcutFocusReason);
                deleteLater();
                m_timer.stop();
                return;
            }
        if (++m_looks == kMostLooks) {
            m_timer.stop();
            deleteLater();
        }
    }

    QWidget* m_screen;
    QString m_text;
    QTimer m_timer;
    int m_looks = 0;
};

} // namespace

PaletteFinder::PaletteFinder(AppContext& context, QObject* parent) : QObject(parent), m_context(context) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause_ms);
    connect(&m_pause, &QTimer::timeout, this, &PaletteFinder::find);
    connect(&context, &AppContext::appearanceChanged, this, &PaletteFinder::forget);
    connect(&context, &AppContext::actorChanged, this, &PaletteFinder::forget);
    connect(&context, &AppContext::rolesChanged, this, &PaletteFinder::forget);
}

void PaletteFinder::forget() {
    m_elsewhere.clear();
    m_toCollect.clear();
    m_collected = false;
    m_index.reset();
}

void PaletteFinder::serve(CommandPalette& palette) {
    m_palette = &palette;
    m_index.reset(); // so that new recordings are found, too
    if (m_work)
        m_work->cancel();
    m_work.reset();
    if (!m_context.loggedIn() || !m_context.site().isOpen())
        return;
    connect(&palette, &CommandPalette::typed, this, &PaletteFinder::look);
    if (!m_collected) {
        m_collected = true;
        for (const ScreenEntry& entry : screenCatalogue())
            if (finds(m_context.roles(), entry))
                m_toCollect << QLatin1String(entry.id);
    }
    QTimer::singleShot(0, this, &PaletteFinder::collectNext);
}

// Collects one screen per turn of the event loop, so that typing stays responsive. The screens are not
// entered, so they read nothing.
void PaletteFinder::collectNext() {
    if (m_toCollect.isEmpty() || !m_palette)
        return;
    const QString id = m_toCollect.takeFirst();
    if (const ScreenEntry* entry = findScreen(id)) {
        const QVariantMap before = m_context.navigator().current().parameters;
        const std::unique_ptr<Screen> screen(entry->make(m_context, {id, {}}));
        Elsewhere found{id, screen->title(), {}};
        for (const ScreenCommand& command : screen->commands())
            found.commands << command.text;
        m_context.navigator().note(before); // some screens note their state when constructed
        m_elsewhere.push_back(std::move(found));
    }
    QTimer::singleShot(0, this, &PaletteFinder::collectNext);
}

void PaletteFinder::look(const QString& typed) {
    m_typed = typed.simplified();
    m_pause.start();
}

void PaletteFinder::find() {
    if (!m_palette)
        return;
    if (m_typed.size() < kShortest) {
        m_palette->showFound({}, {});
        return;
    }
    if (m_index) {
        show(m_index, m_typed);
        return;
    }
    if (m_work)
        return; // reading is in progress; its result is searched for the latest text
    m_palette->say(tr("Searching people, sessions and studies …"));
    SearchQuestion question{m_context.actor(), m_context.language(), m_context.locale(),
                            m_context.site().catalogue()};
    m_work = m_context.background().run(
        m_palette,
        [&database = m_context.site().database(), question = std::move(question)](WorkToken& working) {
            return std::make_shared<const SearchIndex>(readSearchIndex(database, question, working.flag()));
        },
        [this, finder = QPointer<PaletteFinder>(this)](const std::shared_ptr<const SearchIndex>& index) {
            if (!finder)
                return;
            m_work.reset();
            m_index = index;
            find();
        });
}

std::vector<ScreenCommand> PaletteFinder::commandsElsewhere(const QString& typed) const {
    constexpr int kGoodFit = 3;
    std::vector<ScreenCommand> list;
    for (const Elsewhere& there : m_elsewhere) {
        if (there.screen == m_context.navigator().current().screen)
            continue; // already listed as a command of this screen
        for (const QString& command : there.commands)
            if (CommandPalette::fit(typed, command) >= kGoodFit && static_cast<int>(list.size()) < kMost)
                list.push_back(
                    {tr("%1: %2").arg(there.title, command), {}, [this, screen = there.screen, command] {
                         m_context.navigator().go(screen);
                         for (QWidget* window : QApplication::topLevelWidgets())
                             if (auto* shown = window->findChild<Screen*>(QStringLiteral("screen.") + screen);
                                 shown && shown->isVisible())
                                 new FocusWhenReady(shown, command);
                     }});
    }
    return list;
}

void PaletteFinder::show(const std::shared_ptr<const SearchIndex>& index, const QString& typed) {
    std::vector<CommandGroup> groups;
    if (auto commands = commandsElsewhere(typed); !commands.empty())
        groups.push_back({tr("On other screens"), std::move(commands)});
    for (int k = 0; k < static_cast<int>(ThingKind::count); ++k) {
        const auto kind = static_cast<ThingKind>(k);
        const FoundThings found = findThings(*index, kind, typed, kMost);
        if (found.best.empty())
            continue;
        const int more = found.all - static_cast<int>(found.best.size());
        CommandGroup group{more > 0
                               ? tr("%1 (%n more; type more letters)", nullptr, more).arg(titleOfKind(kind))
                               : titleOfKind(kind),
                           {}};
        for (const NamedThing* thing : found.best)
            group.commands.push_back({thing->text, {}, [&context = m_context, place = thing->place] {
                                          context.navigator().go(place);
                                      }});
        groups.push_back(std::move(group));
    }
    m_palette->showFound(std::move(groups), index->problems.empty()
                                                ? QString()
                                                : tr("Not everything could be searched: %1")
                                                      .arg(inWords(index->problems.front(), Tried::reading)));
}

} // namespace chiron::desktop
