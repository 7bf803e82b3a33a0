// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/home/comment_list.h"

#include "database/repositories/session_reader.h"

#include <algorithm>

namespace chiron::desktop {

int newsUpTo(const std::vector<database::PersonId>& authors, database::PersonId self, bool own) {
    int upTo = 0;
    bool concerned = own;
    for (std::size_t i = 0; i < authors.size(); ++i) {
        if (authors[i] == self)
            concerned = true;
        else if (concerned)
            upTo = static_cast<int>(i) + 1;
    }
    return upTo;
}

core::Result<std::vector<FoundComment>>
readComments(const database::Database& database, const database::Actor& actor, const ExerciseTitles& titles) {
    auto connection = database.openReader();
    CHIRON_TRY(connection);
    auto sessions = database::SessionReader(**connection, actor).commentedSessions();
    CHIRON_TRY(sessions);
    const std::map<database::PersonId, std::string> names = shownNames(**connection);
    const auto people = PeopleNames::read(**connection, actor);
    CHIRON_TRY(people);
    std::vector<FoundComment> found;
    for (database::CommentedSession& session : *sessions) {
        bool concerned = session.session.person == actor.personId();
        const SessionRow row = makeSessionRow(std::move(session.session), titles, *people);
        for (std::size_t i = 0; i < session.comments.size(); ++i) {
            const database::SessionComment& comment = session.comments[i];
            const auto name = names.find(comment.author);
            const bool byOther = comment.author != actor.personId();
            concerned = concerned || !byOther;
            found.push_back({row,
                             {comment, name == names.end() ? std::string() : name->second},
                             byOther && concerned,
                             static_cast<int>(i),
                             static_cast<int>(session.comments.size())});
        }
    }
    std::sort(found.begin(), found.end(), [](const FoundComment& a, const FoundComment& b) {
        return a.named.comment.id > b.named.comment.id;
    });
    return found;
}

} // namespace chiron::desktop
