// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/general_page.h"

#include "desktop/frame/app_context.h"
#include "desktop/studies/field_grid.h"
#include "desktop/studies/study_words.h"
#include "desktop/studies/text_claims.h"
#include "desktop/widgets/kit.h"

#include <QCoreApplication>
#include <QPlainTextEdit>
#include <QPointer>

namespace chiron::desktop {

using namespace psychophysics;

void addStudyText(FieldGrid& grid, const DesignPage& page, const QString& label, const QString& name,
                  int lines, const std::function<StudyText&(StudyDesign&)>& text, bool mayBeAbsent,
                  const std::function<void(StudyDesign&)>& follow) {
    StudyDesign now = page.draft.design();
    const StudyText& texts = text(now);
    const auto found = texts.find(page.language.toStdString());
    const QString value = found == texts.end() ? QString() : QString::fromStdString(found->second);
    const auto taken = [&draft = page.draft, language = page.language.toStdString(), name, text, mayBeAbsent,
                        follow](const QString& words) {
        draft.change(QCoreApplication::translate("StudyWords", "Text change"), name,
                     [&](StudyDesign& design) {
                         StudyText& changed = text(design);
                         if (words.isEmpty() && (mayBeAbsent || language != "en"))
                             changed.erase(language);
                         else
                             changed[language] = words.toStdString();
                         if (follow)
                             follow(design);
                     });
    };
    if (lines > 1)
        grid.longText(label, name, value, lines, taken);
    else
        grid.text(label, name, value, taken);
}

void tellRemoved(const DesignPage& page, const QString& what) {
    const auto undo = [draft = QPointer<StudyDraft>(&page.draft), &app = page.app,
                       removed = page.draft.version()] {
        if (draft && draft->version() == removed)
            draft->history().undo();
        else
            app.messages().information(
                draft ? QCoreApplication::translate("StudyWords",
                                                    "The design has been changed since then. Undo in the "
                                                    "study takes back one step after another.")
                      : QCoreApplication::translate(
                            "StudyWords",
                            "You have left the study since then, so this can no longer be undone."));
    };
    page.app.messages().tell(
        {MessageKind::done, what, QCoreApplication::translate("StudyWords", "Undo"), undo});
}

kit::Box titledBox(const Theme& theme, const QString& title) {
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, title, TextStyle::title));
    return box;
}

GeneralPage::GeneralPage(const DesignPage& page, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(page.app.theme().px(16));
    column->addWidget(aimBox(page));
    column->addWidget(consentBox(page));
    column->addStretch();
}

/// What freezing asks for stands first, in sight without scrolling.
QWidget* GeneralPage::aimBox(const DesignPage& page) {
    const Theme& theme = page.app.theme();
    const kit::Box box = titledBox(theme, tr("Aim and ethics"));
    auto* grid = new FieldGrid(theme, page.app.locale(), page.readOnly);
    StudyDraft& draft = page.draft;
    addStudyText(
        *grid, page, tr("Title (required)"), QStringLiteral("design.title"), 1,
        [](StudyDesign& design) -> StudyText& { return design.title; }, false,
        [&draft](StudyDesign& design) {
            if (design.title.contains("en"))
                draft.keepName(design.title.at("en"));
        });
    grid->explain(QStringLiteral("design.title"), tr("The study's name in lists, reports and exports."));
    grid->whole(tr("Planned participants"), QStringLiteral("design.planned"),
                draft.design().participantsPlanned, 0, 100000, [&draft](int now) {
                    draft.change(GeneralPage::tr("Number of participants"), QStringLiteral("design.planned"),
                                 [now](StudyDesign& design) { design.participantsPlanned = now; });
                });
    constexpr UsualNumber kParticipants{1, 100000, 12};
    grid->explain(QStringLiteral("design.planned"),
                  tr("How many people are to take part; the page “Expected precision” shows which difference "
                     "this number can detect."),
                  kParticipants);
    addAim(*grid, page);
    grid->text(
        tr("Ethics approval (required)"), QStringLiteral("design.ethics"),
        QString::fromStdString(draft.design().ethics),
        [&draft](const QString& now) {
            draft.change(GeneralPage::tr("Ethics approval"), QStringLiteral("design.ethics"),
                         [&](StudyDesign& design) { design.ethics = now.trimmed().toStdString(); });
        },
        true);
    grid->explain(QStringLiteral("design.ethics"),
                  tr("The committee with the number and date of its approval, or why none is needed. It is "
                     "frozen with the study."));
    box.layout->addWidget(grid);
    if (!page.readOnly)
        box.layout->addWidget(claimsNotice(page, FalseClaim::Where::aim));
    return box.frame;
}

/// Does not show the template's words as if somebody had written them.
void GeneralPage::addAim(FieldGrid& grid, const DesignPage& page) {
    const QString name = QStringLiteral("design.objective");
    addStudyText(grid, page, tr("Aim (required)"), name, 2,
                 [](StudyDesign& design) -> StudyText& { return design.objective; });
    grid.explain(name, tr("One or two sentences: what is to be found out, and what is expected. It is frozen "
                          "with the study."));
    auto* field = qobject_cast<QPlainTextEdit*>(grid.field(name));
    field->setPlaceholderText(tr("For example: whether tubes of 60 N/m and 120 N/m have the same Weber "
                                 "fraction. We expect no difference."));
    if (isPlaceholderAim(field->toPlainText())) {
        const QSignalBlocker quiet(field);
        field->clear();
    }
}

QWidget* GeneralPage::consentBox(const DesignPage& page) {
    const Theme& theme = page.app.theme();
    const kit::Box box = titledBox(theme, tr("Consent and source"));
    auto* grid = new FieldGrid(theme, page.app.locale(), page.readOnly);
    StudyDraft& draft = page.draft;
    addStudyText(*grid, page, tr("Consent text (required)"), QStringLiteral("design.consent"), 5,
                 [](StudyDesign& design) -> StudyText& { return design.consent; });
    grid->explain(QStringLiteral("design.consent"),
                  tr("What participants agree to before their first trial. The text that was shown is stored "
                     "with each consent."));
    grid->text(
        tr("Source of the design"), QStringLiteral("design.source"),
        QString::fromStdString(draft.design().source),
        [&draft](const QString& now) {
            draft.change(GeneralPage::tr("Source of the design"), QStringLiteral("design.source"),
                         [&](StudyDesign& design) { design.source = now.trimmed().toStdString(); });
        },
        true);
    grid->explain(QStringLiteral("design.source"),
                  tr("Where the design was published, with its DOI; empty for a design of your own."));
    box.layout->addWidget(grid);
    return box.frame;
}

bool isPlaceholderAim(const QString& aim) {
    return aim.trimmed() == QLatin1String(kPlaceholderAim);
}

} // namespace chiron::desktop
