// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/first_start/site_maker.h"
#include "desktop/frame/screen.h"

#include <QPointer>

class QPushButton;
class QComboBox;
class QVBoxLayout;

namespace chiron::desktop {

class AdministratorPage;
class RecoveryCodePanel;
class ScrollPage;
class StatePanel;

/// The first start on this station: set the site up with its administrator, or look at the demonstration. Also where a
/// database has no people yet.
class FirstStartScreen final : public Screen {
    Q_OBJECT
public:
    FirstStartScreen(AppContext& context, const Place& place);
    ~FirstStartScreen() override; ///< a demonstration that is being made is stopped

    QString title() const override;
    QString help() const override;
    void enter() override;
    bool mayLeave() override;

    /// Where the demonstration of this station lies: beside the site's own database, so that both can be there.
    static QString demonstrationFile(const QString& siteFile);

private:
    void showWelcome();
    void showAdministrator();
    void showDemonstration();
    void showRecoveryCode(const QString& name, const QString& code);
    QWidget* choice(const QString& icon, const QString& title, const QString& text, QPushButton* button);
    void setPage(QWidget* page);
    void makeSiteFor(const AdministratorRequest& request);
    void siteMade(const AdministratorRequest& request, core::Result<MadeSite> made);
    void demonstrationMade(core::Result<MadeSite> made);

    std::shared_ptr<WorkToken> m_work; ///< of the demonstration
    QComboBox* m_language;
    ScrollPage* m_scroll;
    QVBoxLayout* m_room = nullptr;
    QWidget* m_page = nullptr;
    QPointer<AdministratorPage> m_administrator;
    QPointer<RecoveryCodePanel> m_code;
    QPointer<StatePanel> m_progress;
    QPointer<QWidget> m_back; ///< shown when the demonstration failed
    database::Actor m_actor = database::Actor::anonymous();
};

} // namespace chiron::desktop
