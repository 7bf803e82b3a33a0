// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/slips_panel.h"

#include "desktop/accounts/form.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/file_folder.h"
#include "desktop/site/site_name.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/suggested_text.h"

#include <QDir>
#include <QFileDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QPrintDialog>
#include <QPrinter>
#include <QTableWidget>

namespace chiron::desktop {

namespace {
constexpr double kTableHeight = 220;
// Setting: the site's name as last entered by this person, used if the site has none of its own.
const QString kSite = QStringLiteral("site_name");
} // namespace

SlipsPanel::SlipsPanel(AppContext& context, const QString& headline,
                       std::vector<database::ImportedPerson> people, QWidget* parent)
    : QWidget(parent), m_context(context), m_people(std::move(people)) {
    const Theme& theme = context.theme();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(12));
    column->addWidget(kit::notice(theme, "good", headline));
    column->addWidget(kit::notice(
        theme, "warning",
        tr("These passwords are shown only now. The program keeps no readable copy: print or save the slips "
           "before you close this window.")));
    column->addWidget(peopleTable());
    m_site = form::textField(theme, column, tr("Name of the site on the slips (may be left empty)"),
                             QStringLiteral("slips.site"));
    new SuggestedText(*m_site);
    m_site->setText(context.settings().ofPerson(context.actor().personId(), kSite, QString()).toString());
    context.background().run(
        this,
        [&database = context.site().database(), actor = context.actor()](WorkToken&) {
            return readSiteName(database, actor);
        },
        [this](const core::Result<QString>& name) {
            if (name && !name->isEmpty() && !m_site->isModified())
                m_site->setText(*name);
        });
    auto* buttons = new QWidget;
    auto* row = new FlowLayout(theme.px(8), buttons);
    auto* paper = kit::button(theme, tr("Print the slips …"), "primary", QStringLiteral("document-print"));
    paper->setObjectName(QStringLiteral("slips.print"));
    connect(paper, &QPushButton::clicked, this, &SlipsPanel::print);
    auto* save = kit::button(theme, tr("Save as PDF …"), "", QStringLiteral("document-save"));
    save->setObjectName(QStringLiteral("slips.save"));
    connect(save, &QPushButton::clicked, this, &SlipsPanel::askFile);
    row->addWidget(paper);
    row->addWidget(save);
    column->addWidget(buttons);
    m_notice = new NoticeArea(theme);
    m_notice->setObjectName(QStringLiteral("slips.notice"));
    column->addWidget(m_notice);
}

QWidget* SlipsPanel::peopleTable() const {
    const Theme& theme = m_context.theme();
    auto* table = new QTableWidget(static_cast<int>(m_people.size()), 3);
    table->setObjectName(QStringLiteral("slips.people"));
    table->setAccessibleName(tr("New people and their passwords"));
    table->setHorizontalHeaderLabels({tr("Full name"), tr("Login name"), tr("Password")});
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setTabKeyNavigation(false);
    table->verticalHeader()->hide();
    table->setMinimumHeight(theme.px(kTableHeight));
    for (int row = 0; row < static_cast<int>(m_people.size()); ++row) {
        const database::ImportedPerson& person = m_people[static_cast<std::size_t>(row)];
        table->setItem(row, 0, new QTableWidgetItem(QString::fromStdString(person.displayName)));
        table->setItem(row, 1, new QTableWidgetItem(QString::fromStdString(person.name)));
        auto* password = new QTableWidgetItem(QString::fromStdString(person.madePassword));
        password->setFont(theme.font(TextStyle::mono));
        table->setItem(row, 2, password);
    }
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setStretchLastSection(true);
    return table;
}

void SlipsPanel::say(const char* kind, const QString& text) {
    m_notice->say(kind, text);
    emit told(m_notice);
}

LoginSlips SlipsPanel::slips() {
    const QString site = m_site->text().trimmed();
    m_context.settings().setOfPerson(m_context.actor().personId(), kSite, site);
    return {site, m_people};
}

void SlipsPanel::print() {
    auto* printer = new QPrinter(QPrinter::HighResolution);
    printer->setPageSize(QPageSize(QPageSize::A4));
    printer->setFullPage(true);
    printer->setDocName(tr("Login slips"));
    auto* dialog = new QPrintDialog(printer, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QObject::destroyed, [printer] { delete printer; });
    connect(dialog, &QDialog::accepted, this, [this, printer] {
        const bool printed = paintLoginSlips(*printer, slips(), report::lightTheme(m_context.locale()));
        m_taken = m_taken || printed;
        if (printed)
            say("good",
                tr("The slips were sent to the printer. Check the paper before you close this window."));
        else
            say("bad", tr("The slips could not be printed. Choose another printer, or save them as PDF."));
    });
    dialog->open();
}

void SlipsPanel::askFile() {
    auto* dialog = new QFileDialog(this, tr("Save the slips as PDF"), QString(), tr("PDF (*.pdf)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("pdf"));
    beginInLastFolder(m_context.settings(), *dialog, QStringLiteral("slips"));
    dialog->selectFile(tr("login-slips") + QStringLiteral(".pdf"));
    connect(dialog, &QFileDialog::fileSelected, this, &SlipsPanel::saveTo);
    dialog->open();
}

void SlipsPanel::saveTo(const QString& file) {
    const auto done = writeLoginSlips(file, slips(), report::lightTheme(m_context.locale()));
    m_taken = m_taken || done.has_value();
    if (done)
        say("good",
            tr("The slips were saved to %1, which only you can read. Delete the file once they are printed.")
                .arg(QDir::toNativeSeparators(file)));
    else
        say("bad", tr("The slips were not saved.\n%1").arg(inWords(done.error())));
}

} // namespace chiron::desktop
